// SPDX-License-Identifier: LGPL-2.1-or-later
#include "eigenvalue_error_cell.h"
#include "nodal_values.h"

#include <deal.II/base/qprojector.h>

#include <deal.II/distributed/tria.h>

#include <deal.II/fe/mapping.h>

#include <Eigen/Dense>

#include <algorithm>

namespace squeal
{
  namespace
  {
    using TriangulationCell = dealii::Triangulation<3>::active_cell_iterator;

    /** FEValues of a scalar element on a cell of the vector-valued one. */
    TriangulationCell
    without_dofs(const CellErrorProblem::Cell &cell)
    {
      return TriangulationCell(cell);
    }

    const dealii::UpdateFlags face_flags = dealii::update_gradients |
                                           dealii::update_JxW_values |
                                           dealii::update_normal_vectors;
  } // namespace



  EnrichmentSpace::EnrichmentSpace(const unsigned int p)
    : degree(p)
  {
    auto nodes = dealii::QGaussLobatto<1>(p + 1).get_points();
    factors    = dealii::Polynomials::generate_complete_Lagrange_basis(nodes);
    nodes.push_back(0.5 * (nodes[p / 2] + nodes[p / 2 + 1]));
    factors.emplace_back(nodes, p + 1); // the bubble
    for (unsigned int k = 0; k <= p + 1; ++k)
      for (unsigned int j = 0; j <= p + 1; ++j)
        for (unsigned int i = 0; i <= p + 1; ++i)
          if (i == p + 1 || j == p + 1 || k == p + 1)
            index.push_back({{i, j, k}});
  }

  Eigen::MatrixXd
  EnrichmentSpace::evaluate(const std::vector<dealii::Point<3>> &points,
                            const int derivative) const
  {
    Eigen::MatrixXd     result(points.size(), size());
    Eigen::MatrixXd     factor(degree + 2, 3);
    std::vector<double> value(2);
    for (unsigned int q = 0; q < points.size(); ++q)
      {
        for (unsigned int d = 0; d < 3; ++d)
          for (unsigned int i = 0; i <= degree + 1; ++i)
            {
              factors[i].value(points[q][d], value);
              factor(i, d) = value[static_cast<int>(d) == derivative ? 1 : 0];
            }
        for (unsigned int a = 0; a < size(); ++a)
          result(q, a) = factor(index[a][0], 0) * factor(index[a][1], 1) *
                         factor(index[a][2], 2);
      }
    return result;
  }

  bool
  EnrichmentSpace::vanishes_on(const unsigned int a,
                               const unsigned int face) const
  {
    return index[a][face / 2] != (face % 2 == 0 ? 0 : degree);
  }



  CellErrorProblem::CellErrorProblem(
    const Discretization       &d,
    const Block                &modes,
    const std::vector<Inertia> &inertia_of_body)
    : discretization(d)
    , inertia(inertia_of_body)
    , fe(d.degree())
    , space(d.degree())
    , quadrature(d.degree() + 2)
    , face_quadrature(d.degree() + 2)
    , volume(d.mapping(),
             fe,
             quadrature,
             dealii::update_values | dealii::update_gradients |
               dealii::update_JxW_values | dealii::update_inverse_jacobians)
    , own_face(d.mapping(), fe, face_quadrature, face_flags)
    , other_face(d.mapping(), fe, face_quadrature, face_flags)
    , own_subface(d.mapping(), fe, face_quadrature, face_flags)
    , other_subface(d.mapping(), fe, face_quadrature, face_flags)
    , unit_values(space.evaluate(quadrature.get_points()))
  {
    for (unsigned int k = 0; k < 3; ++k)
      unit_derivatives[k] = space.evaluate(quadrature.get_points(), k);
    for (const auto &body : d.scene().bodies)
      materials.push_back(material_of(body));

    const auto &system = d.dof_handler().get_fe();
    for (auto &list : dof_of)
      list.resize(fe.n_dofs_per_cell());
    for (unsigned int i = 0; i < system.n_dofs_per_cell(); ++i)
      {
        const auto [c, a] = system.system_to_component_index(i);
        dof_of[c][a]      = i;
      }

    nodal = nodal_values(d, modes);
  }



  CellErrorProblem::Material
  CellErrorProblem::material_of(const BodyParameters &body)
  {
    return {
      elastic_constants(body), body.density, largest_elastic_constant(body)};
  }



  Eigen::MatrixXd
  CellErrorProblem::residuals(const Cell               &cell,
                              const std::vector<Force> &forces,
                              const std::vector<bool>  &set_apart)
  {
    const Material &material = materials[cell->material_id()];
    assemble_volume(cell, material);
    assemble_stiffness(material);
    add_forces(forces);
    for (const unsigned int f : cell->face_indices())
      if (!cell->at_boundary(f))
        add_face(cell, f, material, set_apart);
    for (const unsigned int f : cell->face_indices())
      if (cell->at_boundary(f))
        hold_supported(cell, f, material);
    const Eigen::LLT<Eigen::MatrixXd> factor(stiffness);
    return factor.matrixL().solve(residual);
  }



  CellErrorProblem::CellValues
  CellErrorProblem::cell_values(const Cell &cell) const
  {
    std::vector<dealii::types::global_dof_index> dofs(3 * fe.n_dofs_per_cell());
    cell->get_dof_indices(dofs);
    CellValues result;
    for (unsigned int c = 0; c < 3; ++c)
      {
        result[c].resize(fe.n_dofs_per_cell(), nodal.cols());
        for (unsigned int a = 0; a < fe.n_dofs_per_cell(); ++a)
          result[c].row(a) =
            nodal.row(discretization.relevant_dofs().index_within_set(
              dofs[dof_of[c][a]]));
      }
    return result;
  }



  CellErrorProblem::TensorField
  CellErrorProblem::stresses(const dealii::FEValuesBase<3> &points,
                             const CellValues              &u,
                             const Material                &material) const
  {
    const unsigned int n_q = points.n_quadrature_points;
    TensorField        gradient, stress;
    Eigen::MatrixXd    shape_gradients(n_q, fe.n_dofs_per_cell());
    for (unsigned int k = 0; k < 3; ++k)
      {
        for (unsigned int a = 0; a < fe.n_dofs_per_cell(); ++a)
          for (unsigned int q = 0; q < n_q; ++q)
            shape_gradients(q, a) = points.shape_grad(a, q)[k];
        for (unsigned int c = 0; c < 3; ++c)
          gradient[3 * c + k].noalias() = shape_gradients * u[c];
      }
    for (unsigned int i = 0; i < 9; ++i)
      {
        stress[i].setZero(n_q, nodal.cols());
        for (unsigned int j = 0; j < 9; ++j)
          if (material.C[i][j] != 0.)
            stress[i] += material.C[i][j] * gradient[j];
      }
    return stress;
  }



  CellErrorProblem::Tractions
  CellErrorProblem::tractions(const dealii::FEValuesBase<3> &points,
                              const dealii::FEValuesBase<3> &normals,
                              const CellValues              &u,
                              const Material                &material) const
  {
    const unsigned int n_q = points.n_quadrature_points,
                       n   = fe.n_dofs_per_cell();
    std::array<Eigen::MatrixXd, 3> shape_gradients;
    for (unsigned int l = 0; l < 3; ++l)
      {
        shape_gradients[l].resize(n_q, n);
        for (unsigned int a = 0; a < n; ++a)
          for (unsigned int q = 0; q < n_q; ++q)
            shape_gradients[l](q, a) = points.shape_grad(a, q)[l];
      }
    Tractions       result;
    Eigen::VectorXd along(n_q);
    Eigen::MatrixXd of_component(n_q, n);
    for (unsigned int i = 0; i < 3; ++i)
      {
        result[i].setZero(n_q, nodal.cols());
        for (unsigned int c = 0; c < 3; ++c)
          {
            // sum over k, l of n_k C_ikcl d/dx_l: of few columns beside those
            // of the modes.
            of_component.setZero();
            for (unsigned int l = 0; l < 3; ++l)
              {
                bool is_zero = true;
                along.setZero();
                for (unsigned int k = 0; k < 3; ++k)
                  if (const double C = material.C[3 * i + k][3 * c + l];
                      C != 0.)
                    {
                      is_zero = false;
                      for (unsigned int q = 0; q < n_q; ++q)
                        along[q] += C * normals.normal_vector(q)[k];
                    }
                if (!is_zero)
                  of_component += along.asDiagonal() * shape_gradients[l];
              }
            result[i].noalias() += of_component * u[c];
          }
      }
    return result;
  }



  void
  CellErrorProblem::assemble_volume(const Cell &cell, const Material &material)
  {
    volume.reinit(without_dofs(cell));
    const unsigned int n_q = quadrature.size(), n = space.size();
    values = cell_values(cell);
    weights.resize(n_q);
    Eigen::MatrixXd shape_values(n_q, fe.n_dofs_per_cell());
    for (unsigned int q = 0; q < n_q; ++q)
      {
        weights[q] = volume.JxW(q);
        for (unsigned int a = 0; a < fe.n_dofs_per_cell(); ++a)
          shape_values(q, a) = volume.shape_value(a, q);
      }
    Eigen::VectorXd scale(n_q);
    for (unsigned int k = 0; k < 3; ++k)
      {
        gradients[k].setZero(n_q, n);
        for (unsigned int l = 0; l < 3; ++l)
          {
            for (unsigned int q = 0; q < n_q; ++q)
              scale[q] = volume.inverse_jacobian(q)[l][k];
            gradients[k] += scale.asDiagonal() * unit_derivatives[l];
          }
        weighted_gradients[k] = weights.asDiagonal() * gradients[k];
      }

    const TensorField stress = stresses(volume, values, material);
    const Inertia &W = inertia[inertia.size() == 1 ? 0 : cell->material_id()];
    residual.resize(3 * n, nodal.cols());
    for (unsigned int i = 0; i < 3; ++i)
      {
        const Eigen::MatrixXd u = (material.density * weights).asDiagonal() *
                                  (shape_values * values[i]) * W;
        residual.middleRows(i * n, n).noalias() = unit_values.transpose() * u;
        for (unsigned int k = 0; k < 3; ++k)
          residual.middleRows(i * n, n).noalias() -=
            weighted_gradients[k].transpose() * stress[3 * i + k];
      }
  }



  void
  CellErrorProblem::assemble_stiffness(const Material &material)
  {
    const unsigned int                            n = space.size();
    std::array<std::array<Eigen::MatrixXd, 3>, 3> H;
    for (unsigned int k = 0; k < 3; ++k)
      for (unsigned int l = k; l < 3; ++l)
        {
          H[k][l].noalias() = gradients[k].transpose() * weighted_gradients[l];
          if (l > k)
            H[l][k] = H[k][l].transpose();
        }
    // The lower triangle of blocks suffices.
    stiffness.setZero(3 * n, 3 * n);
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j <= i; ++j)
        for (unsigned int k = 0; k < 3; ++k)
          for (unsigned int l = 0; l < 3; ++l)
            if (const double c = material.C[3 * i + k][3 * j + l]; c != 0.)
              stiffness.block(i * n, j * n, n, n) += c * H[k][l];
  }



  void
  CellErrorProblem::add_forces(const std::vector<Force> &forces)
  {
    if (forces.empty())
      return;
    const unsigned int            n = space.size();
    std::vector<dealii::Point<3>> points;
    for (const auto &force : forces)
      points.push_back(force.unit_point);
    const Eigen::MatrixXd at_points = space.evaluate(points);
    Eigen::MatrixXd       component(forces.size(), nodal.cols());
    for (unsigned int i = 0; i < 3; ++i)
      {
        for (unsigned int q = 0; q < forces.size(); ++q)
          component.row(q) = forces[q].force.row(i);
        residual.middleRows(i * n, n).noalias() +=
          at_points.transpose() * component;
      }
  }



  const Eigen::MatrixXd &
  CellErrorProblem::trace(const Cell        &cell,
                          const unsigned int f,
                          const int          subface)
  {
    using Projector        = dealii::QProjector<3>;
    using Descriptor       = Projector::DataSetDescriptor;
    const auto hexahedron  = dealii::ReferenceCells::Hexahedron;
    const bool orientation = cell->face_orientation(f),
               flip = cell->face_flip(f), rotation = cell->face_rotation(f);
    const unsigned int n = face_quadrature.size();
    const unsigned int first =
      subface < 0
        ? Descriptor::face(hexahedron, f, orientation, flip, rotation, n)
        : Descriptor::subface(hexahedron,
                              f,
                              subface,
                              orientation,
                              flip,
                              rotation,
                              n,
                              dealii::internal::SubfaceCase<3>::case_isotropic);
    auto &stored = traces[{subface < 0, first}];
    if (stored.size() == 0)
      {
        const auto all =
          (subface < 0
             ? Projector::project_to_all_faces(hexahedron, face_quadrature)
             : Projector::project_to_all_subfaces(hexahedron, face_quadrature))
            .get_points();
        stored = space.evaluate({all.begin() + first, all.begin() + first + n});
      }
    return stored;
  }



  void
  CellErrorProblem::add_face(const Cell              &cell,
                             const unsigned int       f,
                             const Material          &material,
                             const std::vector<bool> &set_apart)
  {
    const auto neighbour = cell->neighbor(f);
    if (neighbour->has_children())
      {
        const unsigned int back = cell->neighbor_of_neighbor(f);
        for (unsigned int s = 0; s < cell->face(f)->n_children(); ++s)
          {
            const Cell child = cell->neighbor_child_on_subface(f, s);
            own_subface.reinit(without_dofs(cell), f, s);
            other_face.reinit(without_dofs(child), back);
            add_traction(own_subface,
                         other_face,
                         child,
                         trace(cell, f, s),
                         material,
                         set_apart[child->active_cell_index()]);
          }
        return;
      }
    const Cell other = neighbour;
    own_face.reinit(without_dofs(cell), f);
    const dealii::FEValuesBase<3> *beyond = &other_face;
    if (cell->neighbor_is_coarser(f))
      {
        const auto [back, subface] = cell->neighbor_of_coarser_neighbor(f);
        other_subface.reinit(without_dofs(other), back, subface);
        beyond = &other_subface;
      }
    else
      other_face.reinit(without_dofs(other), cell->neighbor_of_neighbor(f));
    add_traction(own_face,
                 *beyond,
                 other,
                 trace(cell, f, -1),
                 material,
                 set_apart[other->active_cell_index()]);
  }



  void
  CellErrorProblem::add_traction(const dealii::FEValuesBase<3> &own,
                                 const dealii::FEValuesBase<3> &other,
                                 const Cell                    &neighbour,
                                 const Eigen::MatrixXd         &trace,
                                 const Material                &material,
                                 const bool                     own_traction)
  {
    const Material &beyond   = materials[neighbour->material_id()];
    Tractions       traction = tractions(own, own, values, material);
    // Corrections of both sides take the least energy when the stiffer one
    // adapts more to the traction of the softer one.
    const double share =
      own_traction ? 0.
                   : material.modulus / (material.modulus + beyond.modulus);
    if (share > 0.)
      {
        const Tractions theirs =
          tractions(other, own, cell_values(neighbour), beyond);
        for (unsigned int i = 0; i < 3; ++i)
          traction[i] = (1. - share) * traction[i] + share * theirs[i];
      }
    const unsigned int n = space.size(), n_q = own.n_quadrature_points;
    Eigen::VectorXd    area(n_q);
    for (unsigned int q = 0; q < n_q; ++q)
      area[q] = own.JxW(q);
    const Eigen::MatrixXd weighted_trace = area.asDiagonal() * trace;
    for (unsigned int i = 0; i < 3; ++i)
      residual.middleRows(i * n, n).noalias() +=
        weighted_trace.transpose() * traction[i];
  }



  void
  CellErrorProblem::hold_supported(const Cell        &cell,
                                   const unsigned int f,
                                   const Material    &material)
  {
    std::vector<dealii::types::global_dof_index> dofs(3 * fe.n_dofs_per_cell());
    cell->get_dof_indices(dofs);
    for (unsigned int c = 0; c < 3; ++c)
      {
        // Held at zero, or guided: all nodes of the face move as one.
        bool               held  = true;
        const Combination *first = nullptr;
        for (unsigned int a = 0; a < fe.n_dofs_per_cell() && held; ++a)
          if (fe.has_support_on_face(a, f))
            {
              const auto &expansion =
                discretization.expansion(dofs[dof_of[c][a]]);
              if (first == nullptr)
                first = &expansion;
              held = expansion == *first;
            }
        if (!held)
          continue;
        for (unsigned int a = 0; a < space.size(); ++a)
          if (!space.vanishes_on(a, f))
            {
              const unsigned int row = c * space.size() + a;
              stiffness.row(row).setZero();
              stiffness.col(row).setZero();
              stiffness(row, row) = material.modulus;
              residual.row(row).setZero();
            }
      }
  }
} // namespace squeal
