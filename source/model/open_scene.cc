// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/discretization/load_vector.h>
#include <squeal/eigen/mass_basis.h>
#include <squeal/model/imported_system.h>
#include <squeal/model/load_checks.h>
#include <squeal/model/observed_motions.h>
#include <squeal/model/open_scene.h>
#include <squeal/model/pressed_model.h>
#include <squeal/scene/turning.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <random>
#include <set>

namespace squeal
{
  namespace
  {
    /** Points of a body that a disturbance strikes. */
    constexpr unsigned int n_struck = 24;

    /** Between -1/2 and 1/2. */
    double
    random_force(std::mt19937 &generator)
    {
      return generator() / 4294967296. - 0.5;
    }

    Block
    struck_points(const Discretization &d)
    {
      const PointEvaluator evaluator(d);
      const auto          &mesh  = d.coarse_mesh();
      const auto          &scene = d.scene();
      Block                f     = Block::Zero(d.space()->n_owned(), 1);
      std::mt19937         generator(1);
      for (unsigned int b = 0; b < scene.bodies.size(); ++b)
        {
          std::vector<unsigned int> corners;
          for (const auto &cell : mesh.cells)
            if (cell.material_id == b)
              corners.insert(
                corners.end(), cell.vertices.begin(), cell.vertices.end());
          std::vector<dealii::Point<3>> points;
          for (unsigned int i = 0; i < n_struck && !corners.empty(); ++i)
            points.push_back(
              mesh.vertices[corners[generator() % corners.size()]]);
          if (corners.empty()) // a rigid body
            points.push_back(centre_of_gravity(scene.bodies[b]));
          const auto found = evaluator.displacements(b, points);
          for (std::size_t i = 0; i < points.size(); ++i)
            for (unsigned int c = 0; c < 3; ++c)
              if (found.found[i])
                add_functional(*d.space(),
                               found.rows[i][c],
                               random_force(generator),
                               f.col(0));
        }
      return f;
    }

    /** Component of an unknown, 1 to 3 for translations; 0 without names. */
    unsigned int
    component(const ImportedModel &model, const unsigned int dof)
    {
      return model.labels.empty() ? 0 : model.labels[dof].component;
    }

    /** Some translations of every body. */
    Block
    struck_unknowns(const ImportedModel &model)
    {
      Block        f = Block::Zero(model.n_dofs, 1);
      std::mt19937 generator(1);
      for (unsigned int b = 0; b < model.bodies.size(); ++b)
        {
          std::vector<unsigned int> own;
          for (unsigned int i = 0; i < model.n_dofs; ++i)
            if (model.body_of[i] == b && component(model, i) <= 3)
              own.push_back(i);
          for (unsigned int i = 0; i < 3 * n_struck && !own.empty(); ++i)
            f(own[generator() % own.size()], 0) += random_force(generator);
        }
      return f;
    }

    /** The motion of a body's centre of mass along each of x, y, z; where the
     * body is held, of what is free of it. */
    Block
    centre_motion(const ImportedModel &model, const std::string &body)
    {
      const Block rigid  = translations(model, body);
      Block       motion = imported_mass(model)->multiply(rigid);
      for (unsigned int i = 0; i < model.n_dofs; ++i)
        if (model.bodies[model.body_of[i]] != body)
          motion.row(i).setZero();
      for (unsigned int c = 0; c < 3; ++c)
        if (const double mass = rigid.col(c).dot(motion.col(c)); mass > 0.)
          motion.col(c) /= mass;
      return motion;
    }

    /** Mean motion along @p normal, weighted with the mass among them, of the
     * nodes of a body that are furthest along it, the face away from the
     * contact: with cells of one height that is the mean over the area. Of the
     * centre where the nodes are fewer than three or have no mass. */
    Eigen::VectorXd
    far_motion(const ImportedModel        &model,
               const std::string          &body,
               const dealii::Tensor<1, 3> &normal,
               const Block                &centre)
    {
      std::vector<double> heights(model.n_dofs);
      double              lowest = 1e300, highest = -1e300;
      for (unsigned int i = 0; i < model.n_dofs; ++i)
        if (model.bodies[model.body_of[i]] == body)
          {
            for (unsigned int c = 0; c < 3; ++c)
              heights[i] += normal[c] * model.positions[i][c];
            lowest  = std::min(lowest, heights[i]);
            highest = std::max(highest, heights[i]);
          }
      const double    level  = highest - 1e-6 * (highest - lowest);
      Eigen::VectorXd motion = Eigen::VectorXd::Zero(model.n_dofs);
      std::set<long>  nodes;
      for (unsigned int i = 0; i < model.n_dofs; ++i)
        if (const unsigned int c = component(model, i);
            c >= 1 && c <= 3 && heights[i] >= level &&
            model.bodies[model.body_of[i]] == body)
          {
            motion[i] = normal[c - 1];
            nodes.insert(model.labels[i].node);
          }
      const Eigen::VectorXd on_face =
        (motion.array() != 0.)
          .select(
            Eigen::VectorXd(imported_mass(model)->multiply(Block(motion))), 0.);
      const double mass = motion.dot(on_face);
      if (nodes.size() < 3 || !(mass > 0.))
        return centre * Eigen::Vector3d(normal[0], normal[1], normal[2]);
      return on_face / mass;
    }

    /** Mean motion along @p normal of what carries the load whose resultant
     * presses most against it: of its nodes, each with its share of that
     * resultant. NaN where no load presses. */
    Block
    pressing_motion(const ImportedModel        &model,
                    const dealii::Tensor<1, 3> &normal)
    {
      Block motion = Block::Constant(
        model.n_dofs, 1, std::numeric_limits<double>::quiet_NaN());
      double most = 0.;
      for (const std::vector<double> &load : model.loads)
        {
          dealii::Tensor<1, 3> force;
          for (unsigned int i = 0; i < model.n_dofs; ++i)
            if (const unsigned int c = component(model, i); c >= 1 && c <= 3)
              force[c - 1] += load[i];
          const double pressing = pressing_part(force, normal);
          if (pressing <= most)
            continue;
          most = pressing;
          std::map<long, double> shares;
          for (unsigned int i = 0; i < model.n_dofs; ++i)
            if (const unsigned int c = component(model, i); c >= 1 && c <= 3)
              shares[model.labels[i].node] -= load[i] * normal[c - 1] / most;
          motion.setZero();
          for (unsigned int i = 0; i < model.n_dofs; ++i)
            if (const unsigned int c = component(model, i); c >= 1 && c <= 3)
              motion(i, 0) = normal[c - 1] * shares[model.labels[i].node];
        }
      return motion;
    }

    Block
    observed_motions(const ImportedModel &model, const ContactNodes &nodes)
    {
      const unsigned int n = PressedModel::n_observers;
      Block l = Block::Zero(model.n_dofs, n * nodes.pairs().size());
      for (std::size_t p = 0; p < nodes.pairs().size(); ++p)
        {
          const ContactPair &pair = nodes.pairs()[p];
          const auto        &g    = pair.geometry;
          const double       area =
            std::accumulate(g.areas.begin(), g.areas.end(), 0.);
          auto                 own = l.middleCols(n * p, n);
          dealii::Tensor<1, 3> normal;
          for (std::size_t j = 0; j < g.points.size(); ++j)
            {
              normal += g.areas[j] / area * g.frames[j].normal;
              for (unsigned int c = 0; c < 3; ++c)
                for (const auto &[dof, weight] : g.target_rows[j][c])
                  own(dof, PressedModel::target_at_contact) +=
                    g.frames[j].normal[c] * g.areas[j] / area * weight;
            }
          const Block centre =
            centre_motion(model, pair.parameters.source_body);
          own.middleCols(PressedModel::centre_x, 3) = centre;
          if (const auto &far = model.far_faces[p]; !far.empty())
            own.col(PressedModel::far_face) =
              Eigen::Map<const Eigen::VectorXd>(far.data(), far.size());
          else
            own.col(PressedModel::far_face) =
              far_motion(model, pair.parameters.source_body, normal, centre);
          // All round a shaft there is no such normal.
          if (const double size = normal.norm(); size > 0.)
            own.col(PressedModel::loaded_face) =
              pressing_motion(model, normal / size);
        }
      return l;
    }
  } // namespace



  void
  require_motion(const RowSpace       &space,
                 const Block          &force,
                 const LoadParameters &load,
                 const std::string    &section)
  {
    const bool is_asked = load.pressure != 0. || load.force != Vector3{} ||
                          load.moment != Vector3{};
    if (is_asked && inner_products(space, force, force)(0, 0) == 0.)
      throw InputError(
        "'" + section +
        "' moves nothing: supports hold all that "
        "it acts on" +
        (load.face.empty() ? "" : ", the face '" + load.face + "'") +
        " of the body '" + load.body +
        "', along its direction; let it act on what is free");
  }



  LoadParameters
  load_of(const HammerParameters &hammer)
  {
    LoadParameters load;
    load.name  = "hammer";
    load.body  = hammer.body;
    load.face  = hammer.face;
    load.force = hammer.force;
    return load;
  }



  OpenScene
  open_scene(const SceneParameters           &scene,
             const Discretization            &d,
             const std::vector<BodyMatrices> &bodies)
  {
    OpenScene open;
    open.discretization = &d;
    open.separated      = separated_system(d, bodies);
    open.nodes          = ContactNodes(scene.contacts, open.separated.contacts);
    const auto restricted = open.separated.restrict_forces;
    open.force_of         = [&d, restricted](const LoadParameters &load) {
      return restricted(load_vector(d, PointEvaluator(d), load));
    };
    const PointEvaluator evaluator(d);
    Block                nodal = Block::Zero(d.space()->n_owned(), 1);
    for (const auto &load : scene.loads)
      {
        const Block one = load_vector(d, evaluator, load);
        // A held support is kept where its loads have moved it.
        if (!has_held_support(scene))
          require_motion(*open.separated.system.space,
                         restricted(one),
                         load,
                         "Scene/Load " + load.name);
        nodal += one;
      }
    open.load     = restricted(nodal);
    open.observed = restricted(squeal::observed_motions(d, open.nodes, bodies));
    open.struck   = restricted(struck_points(d));
    return open;
  }



  OpenScene
  open_scene(const SceneParameters &scene, const ImportedModel &model)
  {
    for (const ContactParameters &contact : scene.contacts)
      if (std::find(model.bodies.begin(),
                    model.bodies.end(),
                    contact.source_body) == model.bodies.end())
        throw InputError("Scene/Contact " + contact.name +
                         ": 'Source body' = '" + contact.source_body +
                         "' is not a body of 'Node table file'");
    OpenScene open;
    open.separated = imported_parts(model);
    add_open_contacts(model, open.separated);
    open.nodes = ContactNodes(scene.contacts, open.separated.contacts);
    Block                        all = Block::Zero(model.n_dofs, 1);
    std::map<std::string, Block> of_load;
    for (std::size_t l = 0; l < scene.loads.size(); ++l)
      {
        const Block force = Eigen::Map<const Eigen::VectorXd>(
          model.loads[l].data(), model.loads[l].size());
        of_load.emplace(scene.loads[l].name, force);
        all += force;
      }
    open.load     = all;
    open.force_of = [of_load](const LoadParameters &load) {
      return of_load.at(load.name);
    };
    open.observed = observed_motions(model, open.nodes);
    open.struck   = struck_unknowns(model);
    return open;
  }
} // namespace squeal
