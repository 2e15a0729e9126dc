// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/contact/mortar.h>
#include <squeal/discretization/face_quadrature.h>

#include <deal.II/base/quadrature_lib.h>

#include <deal.II/distributed/tria.h>

#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping.h>

#include <Eigen/Dense>

#include <map>

namespace squeal
{
  namespace
  {
    constexpr unsigned int ground = -1u;

    /** One source face: nodes (identified by their z row) and the dual shape
     * functions times the area at every point. */
    struct SourceFace
    {
      std::vector<unsigned int>                node_keys;
      std::vector<dealii::Point<3>>            node_points;
      std::vector<std::array<unsigned int, 3>> node_rows;
      std::vector<double>                      integrals; /**< int phi_j */
      std::vector<dealii::Point<3>>            points;
      Eigen::MatrixXd dual; /**< nodes x points, psi_j w_q */
    };



    std::array<unsigned int, 3>
    rows_of_node(const Discretization                               &d,
                 const dealii::FiniteElement<3>                     &fe,
                 const std::vector<dealii::types::global_dof_index> &dofs,
                 const std::array<unsigned int, 3>                  &local,
                 const std::string                                  &where)
    {
      std::array<unsigned int, 3> rows{{-1u, -1u, -1u}};
      (void)fe;
      for (unsigned int c = 0; c < 3; ++c)
        {
          const Combination &parts = d.expansion(dofs[local[c]]);
          if (parts.size() > 1)
            throw InputError(where +
                             ": the source face carries hanging nodes; refine "
                             "the target body only");
          if (parts.size() == 1)
            rows[c] = parts[0].first;
        }
      return rows;
    }



    /** Faces of this rank with their dual functions A phi, A = D_e M_e^-1. */
    std::vector<SourceFace>
    local_faces(const Discretization &d,
                const unsigned int    id,
                const std::string    &where,
                const unsigned int    subdivisions)
    {
      const auto                &fe = d.dof_handler().get_fe();
      const dealii::QGauss<2>    base(d.degree() + 2);
      const dealii::QIterated<2> quadrature(dealii::QGauss<1>(d.degree() + 2),
                                            subdivisions);
      dealii::FEFaceValues<3>    values(d.mapping(),
                                     fe,
                                     quadrature,
                                     dealii::update_values |
                                       dealii::update_quadrature_points |
                                       dealii::update_JxW_values);
      std::vector<dealii::types::global_dof_index> dofs(fe.n_dofs_per_cell());
      std::vector<SourceFace>                      faces;
      for (const auto &cell : d.dof_handler().active_cell_iterators())
        if (cell->is_locally_owned())
          for (const unsigned int f : cell->face_indices())
            if (cell->face(f)->at_boundary() &&
                cell->face(f)->boundary_id() == id)
              {
                values.reinit(cell, f);
                cell->get_dof_indices(dofs);
                SourceFace face;
                // Nodes of the face: one triple of components each.
                std::map<unsigned int, std::array<unsigned int, 3>> nodes;
                for (unsigned int i = 0; i < dofs.size(); ++i)
                  if (fe.has_support_on_face(i, f))
                    {
                      const auto [c, base_index] =
                        fe.system_to_component_index(i);
                      nodes[base_index][c] = i;
                    }
                const unsigned int n = nodes.size(), n_q = quadrature.size();
                Eigen::MatrixXd    phi(n, n_q);
                Eigen::VectorXd    w(n_q);
                unsigned int       k = 0;
                for (const auto &[base_index, local] : nodes)
                  {
                    for (unsigned int q = 0; q < n_q; ++q)
                      phi(k, q) = values.shape_value(local[0], q);
                    face.node_points.push_back(
                      d.mapping().transform_unit_to_real_cell(
                        cell, fe.unit_support_point(local[0])));
                    face.node_rows.push_back(
                      rows_of_node(d, fe, dofs, local, where));
                    face.node_keys.push_back(dofs[local[2]]);
                    ++k;
                  }
                for (unsigned int q = 0; q < n_q; ++q)
                  {
                    w[q] = values.JxW(q);
                    face.points.push_back(values.quadrature_point(q));
                  }
                const Eigen::VectorXd integrals = phi * w;
                const Eigen::MatrixXd M =
                  phi * w.asDiagonal() * phi.transpose();
                face.dual =
                  integrals.asDiagonal() *
                  M.ldlt().solve(Eigen::MatrixXd(phi * w.asDiagonal()));
                face.integrals.assign(integrals.data(), integrals.data() + n);
                faces.push_back(std::move(face));
              }
      return faces;
    }



    /** Every rank's faces as one list on every rank, packed as numbers. */
    std::vector<SourceFace>
    gather_faces(const std::vector<SourceFace> &mine, const MPI_Comm comm)
    {
      std::vector<double> packed;
      for (const auto &face : mine)
        {
          packed.push_back(face.node_keys.size());
          packed.push_back(face.points.size());
          for (std::size_t k = 0; k < face.node_keys.size(); ++k)
            {
              packed.push_back(face.node_keys[k]);
              packed.push_back(face.integrals[k]);
              for (unsigned int c = 0; c < 3; ++c)
                {
                  packed.push_back(face.node_points[k][c]);
                  packed.push_back(face.node_rows[k][c]);
                }
            }
          for (const auto &x : face.points)
            packed.insert(packed.end(), {x[0], x[1], x[2]});
          packed.insert(packed.end(),
                        face.dual.data(),
                        face.dual.data() + face.dual.size());
        }
      const std::vector<double> all = all_gather(packed, comm);
      std::vector<SourceFace>   faces;
      for (std::size_t p = 0; p < all.size();)
        {
          SourceFace        face;
          const std::size_t n = all[p++], n_q = all[p++];
          for (std::size_t k = 0; k < n; ++k)
            {
              face.node_keys.push_back(all[p++]);
              face.integrals.push_back(all[p++]);
              dealii::Point<3>            x;
              std::array<unsigned int, 3> rows;
              for (unsigned int c = 0; c < 3; ++c)
                {
                  x[c]    = all[p++];
                  rows[c] = static_cast<unsigned int>(all[p++]);
                }
              face.node_points.push_back(x);
              face.node_rows.push_back(rows);
            }
          for (std::size_t q = 0; q < n_q; ++q, p += 3)
            face.points.emplace_back(all[p], all[p + 1], all[p + 2]);
          face.dual = Eigen::Map<const Eigen::MatrixXd>(&all[p], n, n_q);
          p += n * n_q;
          faces.push_back(std::move(face));
        }
      return faces;
    }
  } // namespace



  MortarCoupling
  make_mortar_coupling(const Discretization &d,
                       const PointEvaluator &evaluator,
                       const unsigned int    source_face_id,
                       const unsigned int    target_body,
                       const std::string    &where,
                       const unsigned int    subdivisions)
  {
    const auto faces =
      gather_faces(local_faces(d, source_face_id, where, subdivisions),
                   d.space()->communicator());
    std::vector<dealii::Point<3>> points;
    for (const auto &face : faces)
      points.insert(points.end(), face.points.begin(), face.points.end());
    PointEvaluator::Result target;
    if (target_body != ground)
      {
        target = evaluator.displacements(target_body, points, 1e-4);
        for (std::size_t q = 0; q < points.size(); ++q)
          if (!target.found[q])
            throw InputError(where + ": the faces do not meet at (" +
                             std::to_string(points[q][0]) + ", " +
                             std::to_string(points[q][1]) + ", " +
                             std::to_string(points[q][2]) + ") m");
      }

    std::map<unsigned int, std::size_t>                        number;
    std::vector<std::array<std::map<unsigned int, double>, 3>> sums;
    MortarCoupling                                             result;
    std::size_t                                                first = 0;
    for (const auto &face : faces)
      {
        for (std::size_t k = 0; k < face.node_keys.size(); ++k)
          {
            const auto [it, is_new] =
              number.emplace(face.node_keys[k], result.nodes.size());
            if (is_new)
              {
                result.nodes.push_back(face.node_points[k]);
                result.weights.push_back(0.);
                result.source_rows.push_back(face.node_rows[k]);
                sums.emplace_back();
              }
            const std::size_t j = it->second;
            result.weights[j] += face.integrals[k];
            if (target_body != ground)
              for (std::size_t q = 0; q < face.points.size(); ++q)
                for (unsigned int c = 0; c < 3; ++c)
                  for (const auto &[row, weight] : target.rows[first + q][c])
                    sums[j][c][row] += face.dual(k, q) * weight;
          }
        first += face.points.size();
      }
    result.target_rows.resize(result.nodes.size());
    for (std::size_t j = 0; j < result.nodes.size(); ++j)
      for (unsigned int c = 0; c < 3; ++c)
        for (const auto &[row, weight] : sums[j][c])
          result.target_rows[j][c].emplace_back(row,
                                                weight / result.weights[j]);
    return result;
  }



  MortarCoupling
  make_node_coupling(const Discretization &d,
                     const PointEvaluator &evaluator,
                     const unsigned int    source_face_id,
                     const unsigned int    target_body,
                     const std::string    &where)
  {
    MortarCoupling result =
      make_mortar_coupling(d, evaluator, source_face_id, ground, where, 1);
    if (target_body == ground)
      return result;
    const auto target =
      evaluator.displacements(target_body, result.nodes, 1e-4);
    for (std::size_t j = 0; j < result.nodes.size(); ++j)
      if (!target.found[j])
        throw InputError(where + ": the faces do not meet at (" +
                         std::to_string(result.nodes[j][0]) + ", " +
                         std::to_string(result.nodes[j][1]) + ", " +
                         std::to_string(result.nodes[j][2]) + ") m");
    result.target_rows = target.rows;
    return result;
  }
} // namespace squeal
