// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nodal_values.h"
#include "point_forces_in_cells.h"

#include <squeal/discretization/element_matrices.h>
#include <squeal/discretization/face_tractions.h>

#include <deal.II/distributed/tria.h>

#include <deal.II/fe/fe_values.h>

namespace squeal
{
  namespace
  {
    /** The points of a cell: their numbers and unit coordinates. */
    struct PointsInCell
    {
      std::vector<unsigned int>     number;
      std::vector<dealii::Point<3>> unit;
    };

    PointsInCell
    points_in_cell(const Discretization                &d,
                   const Discretization::CellIterator  &cell,
                   const std::vector<dealii::Point<3>> &points)
    {
      const double     diameter = cell->diameter();
      const auto       centre   = cell->center();
      PointsInCell     result;
      dealii::Point<3> unit;
      for (unsigned int p = 0; p < points.size(); ++p)
        if (points[p].distance(centre) < diameter &&
            find_in_cell(d, cell, points[p], unit))
          {
            result.number.push_back(p);
            result.unit.push_back(unit);
          }
      return result;
    }

    /** Row i: the traction component i at a point of the shape functions of a
     * cell (columns), Pa/m. */
    Eigen::MatrixXd
    shape_tractions(const dealii::FEValues<3>  &shapes,
                    const unsigned int          q,
                    const ElasticTensor        &C,
                    const dealii::Tensor<1, 3> &normal)
    {
      const auto     &fe     = shapes.get_fe();
      Eigen::MatrixXd result = Eigen::MatrixXd::Zero(3, shapes.dofs_per_cell);
      for (unsigned int a = 0; a < shapes.dofs_per_cell; ++a)
        {
          const auto         gradient = shapes.shape_grad(a, q);
          const unsigned int c        = fe.system_to_component_index(a).first;
          for (unsigned int i = 0; i < 3; ++i)
            for (unsigned int k = 0; k < 3; ++k)
              for (unsigned int l = 0; l < 3; ++l)
                result(i, a) +=
                  normal[k] * C[3 * i + k][3 * c + l] * gradient[l];
        }
      return result;
    }
  } // namespace



  FaceTractions
  face_tractions(const Discretization                    &d,
                 const Block                             &modes,
                 const unsigned int                       body,
                 const std::vector<dealii::Point<3>>     &points,
                 const std::vector<dealii::Tensor<1, 3>> &normals)
  {
    const Eigen::MatrixXd nodal = nodal_values(d, modes);
    const ElasticTensor   C     = elastic_constants(d.scene().bodies[body]);
    FaceTractions         result;
    result.values = Eigen::MatrixXd::Zero(3 * points.size(), modes.cols());
    Eigen::MatrixXd n_holders = Eigen::MatrixXd::Zero(points.size(), 1);
    std::vector<dealii::types::global_dof_index> dofs;
    for (const auto &cell : d.dof_handler().active_cell_iterators())
      {
        if (!cell->is_locally_owned() || cell->material_id() != body)
          continue;
        const PointsInCell here = points_in_cell(d, cell, points);
        if (here.number.empty())
          continue;
        dealii::FEValues<3> shapes(d.mapping(),
                                   cell->get_fe(),
                                   dealii::Quadrature<3>(here.unit),
                                   dealii::update_gradients);
        shapes.reinit(cell);
        dofs.resize(shapes.dofs_per_cell);
        cell->get_dof_indices(dofs);
        Eigen::MatrixXd u(dofs.size(), modes.cols());
        for (unsigned int a = 0; a < dofs.size(); ++a)
          u.row(a) = nodal.row(d.relevant_dofs().index_within_set(dofs[a]));
        for (unsigned int q = 0; q < here.number.size(); ++q)
          {
            const unsigned int p = here.number[q];
            result.values.middleRows(3 * p, 3) +=
              shape_tractions(shapes, q, C, normals[p]) * u;
            n_holders(p, 0) += 1.;
          }
      }
    d.space()->sum(result.values);
    d.space()->sum(n_holders);
    for (unsigned int p = 0; p < points.size(); ++p)
      {
        result.found.push_back(n_holders(p, 0) > 0.);
        if (result.found[p])
          result.values.middleRows(3 * p, 3) /= n_holders(p, 0);
      }
    return result;
  }
} // namespace squeal
