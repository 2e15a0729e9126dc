// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/contact/contact_resultant.h>
#include <squeal/discretization/face_quadrature.h>
#include <squeal/discretization/load_vector.h>
#include <squeal/model/observed_motions.h>
#include <squeal/model/pressed_model.h>
#include <squeal/parameters/glued_bodies.h>

#include <deal.II/base/quadrature_lib.h>

#include <deal.II/distributed/tria.h>

#include <deal.II/fe/fe_values.h>

#include <limits>
#include <map>
#include <numeric>
#include <set>

namespace squeal
{
  namespace
  {
    /** @p body and all that ties and springs join it to. */
    std::set<std::string>
    joined_bodies(const SceneParameters &scene, const std::string &body)
    {
      std::set<std::string> joined = {body};
      const auto join = [&](const std::string &a, const std::string &b) {
        if (joined.count(a) == joined.count(b))
          return false;
        joined.insert(a);
        joined.insert(b);
        return true;
      };
      for (bool grows = true; grows;)
        {
          grows = false;
          for (const auto &[a, b] : glued_bodies(scene))
            grows = join(a, b) || grows;
          for (const auto &spring : scene.springs)
            if (spring.other_body != "ground")
              grows = join(spring.body, spring.other_body) || grows;
        }
      return joined;
    }

    /** What a load pushes with, N: its force, and its pressure over the face.
     */
    dealii::Tensor<1, 3>
    resultant_of(const Discretization &d, const LoadParameters &load)
    {
      const auto          &scene = d.scene();
      dealii::Tensor<1, 3> force;
      for (unsigned int c = 0; c < 3; ++c)
        force[c] = load.force[c];
      if (scene.bodies[body_index(scene, load.body)].shape ==
            BodyParameters::Shape::rigid ||
          load.pressure == 0.)
        return force;
      const FaceQuadrature face = face_quadrature(
        d, face_id(d.coarse_mesh(), scene, load.body, load.face));
      for (std::size_t q = 0; q < face.points.size(); ++q)
        force -= load.pressure * face.areas[q] * face.normals[q];
      return force;
    }

    /** The load that presses a pair on: of those on the source and on what it
     * is joined to, else of all, the one whose resultant against the normal @p
     * n is largest. Null where none has one, as where a moment swings a shoe
     * against its drum. */
    const LoadParameters *
    pressing_load(const Discretization       &d,
                  const ContactPair          &pair,
                  const dealii::Tensor<1, 3> &n)
    {
      const auto &scene  = d.scene();
      const auto  joined = joined_bodies(scene, pair.parameters.source_body);
      for (const bool only_joined : {true, false})
        {
          const LoadParameters *best = nullptr;
          double                most = 0.;
          for (const auto &load : scene.loads)
            if (!only_joined || joined.count(load.body) > 0)
              if (const double force = pressing_part(resultant_of(d, load), n);
                  force > most)
                {
                  best = &load;
                  most = force;
                }
          if (best)
            return best;
        }
      return nullptr;
    }

    /** Mean motion of the face of @p load along the normal @p n of a pair: what
     * an even force of 1 N along it would work on. */
    Block
    motion_along(const Discretization       &d,
                 const PointEvaluator       &evaluator,
                 LoadParameters              load,
                 const dealii::Tensor<1, 3> &n)
    {
      for (unsigned int c = 0; c < 3; ++c)
        {
          load.force[c]  = n[c];
          load.moment[c] = 0.;
        }
      load.pressure = 0.;
      return load_vector(d, evaluator, load);
    }



    using Rows = std::array<Functionals::Row, 3>;

    /** Mean motion of a meshed body along x, y and z: that of its centre of
     * mass, wherever that lies, as the density of a body is even. @p volume in
     * m^3. The same on every rank. */
    Rows
    mean_motion(const Discretization &d,
                const unsigned int    body,
                const double          volume)
    {
      const auto             &fe = d.dof_handler().get_fe();
      const dealii::QGauss<3> quadrature(d.degree() + 1);
      dealii::FEValues<3>     values(d.mapping(),
                                 fe,
                                 quadrature,
                                 dealii::update_values |
                                   dealii::update_JxW_values);
      std::vector<dealii::types::global_dof_index>  dofs(fe.dofs_per_cell);
      std::array<std::map<unsigned int, double>, 3> mine;
      for (const auto &cell : d.dof_handler().active_cell_iterators())
        if (cell->is_locally_owned() && cell->material_id() == body)
          {
            values.reinit(cell);
            cell->get_dof_indices(dofs);
            for (unsigned int i = 0; i < dofs.size(); ++i)
              {
                double share = 0.;
                for (unsigned int q = 0; q < quadrature.size(); ++q)
                  share += values.shape_value(i, q) * values.JxW(q) / volume;
                const unsigned int c = fe.system_to_component_index(i).first;
                for (const auto &[row, weight] : d.expansion(dofs[i]))
                  mine[c][row] += share * weight;
              }
          }
      std::vector<double> packed;
      for (unsigned int c = 0; c < 3; ++c)
        for (const auto &[row, weight] : mine[c])
          packed.insert(packed.end(), {double(c), double(row), weight});
      const auto all = all_gather(packed, d.space()->communicator());
      Rows       result;
      for (std::size_t k = 0; k < all.size(); k += 3)
        result[static_cast<unsigned int>(all[k])].emplace_back(
          static_cast<unsigned int>(all[k + 1]), all[k + 2]);
      return result;
    }

    /** Motion of the centre of gravity of a source body. Of a shoe or an arc it
     * lies beside the material, where no cell has a motion. */
    Rows
    centre_motion_of(const Discretization &d,
                     const PointEvaluator &evaluator,
                     const unsigned int    body,
                     const BodyMatrices   &matrices)
    {
      const auto at = evaluator.displacements(body, {matrices.centre}, 1e-4);
      return at.found[0] ? at.rows[0] : mean_motion(d, body, matrices.volume);
    }



    /** Those of one pair. */
    void
    add_observers(const Discretization &d,
                  const PointEvaluator &evaluator,
                  const ContactPair    &pair,
                  const BodyMatrices   &body,
                  Eigen::Ref<Block>     l)
    {
      const auto        &scene = d.scene();
      const auto        &g     = pair.geometry;
      const RowSpace    &space = *d.space();
      const unsigned int source =
        body_index(scene, pair.parameters.source_body);
      const double area   = std::accumulate(g.areas.begin(), g.areas.end(), 0.);
      const Rows   centre = centre_motion_of(d, evaluator, source, body);
      for (unsigned int c = 0; c < 3; ++c)
        add_functional(space, centre[c], 1., l.col(PressedModel::centre_x + c));
      // The far face may be inside, tied to another body: the contact nodes
      // mirrored at the centre of the source.
      std::vector<dealii::Point<3>> mirrored;
      for (std::size_t j = 0; j < g.points.size(); ++j)
        {
          const auto &n = g.frames[j].normal;
          mirrored.push_back(g.points[j] +
                             2. * ((body.centre - g.points[j]) * n) * n);
        }
      const auto far = evaluator.displacements(source, mirrored, 1e-4);
      for (std::size_t j = 0; j < g.points.size(); ++j)
        for (unsigned int c = 0; c < 3; ++c)
          if (const double n = g.frames[j].normal[c]; n != 0.)
            {
              const double share = n * g.areas[j] / area;
              add_functional(space,
                             g.target_rows[j][c],
                             share,
                             l.col(PressedModel::target_at_contact));
              add_functional(space,
                             far.found[j] ? far.rows[j][c] : centre[c],
                             share,
                             l.col(PressedModel::far_face));
            }
      if (std::count(far.found.begin(), far.found.end(), true) == 0)
        l.col(PressedModel::far_face)
          .setConstant(std::numeric_limits<double>::quiet_NaN());
      const auto normal = mean_frame(g).normal;
      if (const LoadParameters *load = pressing_load(d, pair, normal))
        l.col(PressedModel::loaded_face) =
          motion_along(d, evaluator, *load, normal);
      else
        l.col(PressedModel::loaded_face)
          .setConstant(std::numeric_limits<double>::quiet_NaN());
    }
  } // namespace



  double
  pressing_part(const dealii::Tensor<1, 3> &force,
                const dealii::Tensor<1, 3> &normal)
  {
    constexpr double least_share = 1e-6;
    const double     part        = -(force * normal);
    return part > least_share * force.norm() ? part : 0.;
  }



  void
  add_functional(const RowSpace             &space,
                 const Functionals::Row     &row,
                 const double                factor,
                 Eigen::Ref<Eigen::VectorXd> column)
  {
    const auto first = space.first_owned(), n = space.n_owned();
    for (const auto &[r, weight] : row)
      if (r >= first && r < first + n)
        column[r - first] += factor * weight;
  }



  Block
  observed_motions(const Discretization            &d,
                   const ContactNodes              &nodes,
                   const std::vector<BodyMatrices> &bodies)
  {
    const PointEvaluator evaluator(d);
    const unsigned int   n = PressedModel::n_observers;
    Block l = Block::Zero(d.space()->n_owned(), n * nodes.pairs().size());
    for (std::size_t i = 0; i < nodes.pairs().size(); ++i)
      {
        const ContactPair &pair = nodes.pairs()[i];
        Block              part = Block::Zero(l.rows(), n);
        add_observers(
          d,
          evaluator,
          pair,
          bodies[body_index(d.scene(), pair.parameters.source_body)],
          part);
        l.middleCols(n * i, n) = part;
      }
    return l;
  }
} // namespace squeal
