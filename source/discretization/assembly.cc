// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patterned_matrix.h"

#include <squeal/discretization/assembly.h>
#include <squeal/discretization/centrifugal_stress.h>
#include <squeal/discretization/element_matrices.h>
#include <squeal/scene/turning.h>

#include <deal.II/base/quadrature_lib.h>

#include <deal.II/distributed/tria.h>

#include <Eigen/Dense>

#include <algorithm>
#include <numeric>

namespace squeal
{
  namespace
  {
    /** Owned cells of a body with their rows. */
    struct BodyCells
    {
      std::vector<Discretization::CellIterator> cells;
      std::vector<CellRows>                     rows;
    };

    BodyCells
    cells_of(const Discretization  &d,
             const unsigned int     body,
             const ElementMatrices &element)
    {
      BodyCells result;
      for (const auto &cell : d.dof_handler().active_cell_iterators())
        if (cell->is_locally_owned() && cell->material_id() == body)
          {
            result.cells.push_back(cell);
            result.rows.push_back(cell_rows(d, cell, element));
          }
      return result;
    }



    BodyMatrices
    assemble_meshed_body(const Discretization &d, const unsigned int body)
    {
      const auto     &p = d.scene().bodies[body];
      ElementMatrices element(
        d.dof_handler(), d.mapping(), d.has_lumped_mass());
      const auto [cells, rows] = cells_of(d, body, element);

      const auto         &carrier = carrier_of(d.scene(), body);
      const bool          turning = carrier.rotation_speed != 0.;
      const ElasticTensor C       = elastic_tensor(p);
      PatternedMatrix     K(d.space(), rows, false), M(d.space(), rows, true);
      PatternedMatrix     G(
        d.space(), turning ? rows : std::vector<CellRows>(), true);
      PatternedMatrix N(
        d.space(), turning ? rows : std::vector<CellRows>(), true);
      G.transpose_sign = -1.;
      Eigen::MatrixXd matrix, second;
      for (unsigned int c = 0; c < cells.size(); ++c)
        {
          element.reinit(cells[c]);
          element.stiffness(C, matrix);
          K.add(rows[c], matrix);
          element.mass(matrix);
          M.add(rows[c], matrix);
          if (turning)
            {
              const Vector3 &axis = carrier.centre_of_rotation();
              element.rotation(axis[0], axis[1], matrix, second);
              G.add(rows[c], matrix);
              N.add(rows[c], second);
            }
        }
      BodyMatrices result;
      result.stiffness = K.finish();
      result.mass      = M.finish();
      if (turning)
        {
          result.gyroscopic = G.finish();
          // Both go with rho Omega^2.
          const auto convective = std::make_shared<SparseMatrix>(*N.finish());
          convective->add(1., *centrifugal_stress_stiffness(d, body));
          result.convective = convective;
        }
      return result;
    }



    void
    compute_volume(const Discretization &d, std::vector<BodyMatrices> &bodies)
    {
      const dealii::QGauss<3> quadrature(d.degree() + 1);
      dealii::FEValues<3>     values(d.mapping(),
                                 d.dof_handler().get_fe(),
                                 quadrature,
                                 dealii::update_quadrature_points |
                                   dealii::update_JxW_values);
      std::vector<double>     moments(4 * bodies.size(), 0.);
      for (const auto &cell : d.dof_handler().active_cell_iterators())
        if (cell->is_locally_owned())
          {
            values.reinit(cell);
            double *m = &moments[4 * cell->material_id()];
            for (unsigned int q = 0; q < quadrature.size(); ++q)
              {
                m[0] += values.JxW(q);
                for (unsigned int c = 0; c < 3; ++c)
                  m[1 + c] += values.JxW(q) * values.quadrature_point(q)[c];
              }
          }
      MPI_Allreduce(MPI_IN_PLACE,
                    moments.data(),
                    static_cast<int>(moments.size()),
                    MPI_DOUBLE,
                    MPI_SUM,
                    d.space()->communicator());
      for (unsigned int b = 0; b < bodies.size(); ++b)
        if (moments[4 * b] > 0.)
          {
            bodies[b].volume = moments[4 * b];
            for (unsigned int c = 0; c < 3; ++c)
              bodies[b].centre[c] = moments[4 * b + 1 + c] / moments[4 * b];
          }
    }



    BodyMatrices
    rigid_body(const Discretization &d, const unsigned int body)
    {
      const auto  &p = d.scene().bodies[body];
      const auto   J = turned_tensor(p, p.inertia);
      Triplets     lower;
      BodyMatrices result;
      const auto   add =
        [&](const unsigned int i, const unsigned int j, const double value) {
          const unsigned int row    = d.rigid_row(body, i),
                             column = d.rigid_row(body, j);
          if (row != -1u && column != -1u && value != 0. &&
              d.space()->rank() == 0)
            lower.add(d.space()->local(std::max(row, column)),
                      d.space()->local(std::min(row, column)),
                      value);
        };
      for (unsigned int i = 0; i < 3; ++i)
        {
          add(i, i, p.mass);
          for (unsigned int j = 0; j <= i; ++j)
            add(3 + i, 3 + j, J[i][j]);
        }
      result.mass   = std::make_shared<SparseMatrix>(d.space(), lower);
      result.centre = centre_of_gravity(p);
      return result;
    }
  } // namespace



  TurningAxes
  turning_axes(const Discretization &d, const unsigned int body)
  {
    ElementMatrices element(d.dof_handler(), d.mapping(), d.has_lumped_mass());
    const auto [cells, rows] = cells_of(d, body, element);
    PatternedMatrix G(d.space(), rows, false), N(d.space(), rows, true);
    G.transpose_sign = -1.;
    Eigen::MatrixXd coriolis, centrifugal;
    for (unsigned int c = 0; c < cells.size(); ++c)
      {
        element.reinit(cells[c]);
        element.turning_axes(coriolis, centrifugal);
        G.add(rows[c], coriolis);
        N.add(rows[c], centrifugal);
      }
    return {G.finish(), N.finish()};
  }



  std::vector<BodyMatrices>
  assemble_bodies(const Discretization &d)
  {
    std::vector<BodyMatrices> result;
    for (unsigned int b = 0; b < d.scene().bodies.size(); ++b)
      result.push_back(d.scene().bodies[b].shape == BodyParameters::Shape::rigid
                         ? rigid_body(d, b)
                         : assemble_meshed_body(d, b));
    if (d.has_mesh())
      compute_volume(d, result);
    return result;
  }
} // namespace squeal
