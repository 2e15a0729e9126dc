// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patterned_matrix.h"

#include <squeal/base/mumps.h>
#include <squeal/discretization/centrifugal_stress.h>
#include <squeal/scene/turning.h>

#include <deal.II/distributed/tria.h>

#include <algorithm>

namespace squeal
{
  namespace
  {
    /** A turning body, its cells and their rows. */
    struct TurningBody
    {
      TurningBody(const Discretization &d, const unsigned int body)
        : discretization(d)
        , element(d.dof_handler(), d.mapping(), false)
        , law(elastic_tensor(d.scene().bodies[body]))
        , axis(carrier_of(d.scene(), body).centre_of_rotation())
      {
        for (const auto &cell : d.dof_handler().active_cell_iterators())
          if (cell->is_locally_owned() && cell->material_id() == body)
            {
              cells.push_back(cell);
              rows.push_back(cell_rows(d, cell, element));
            }
      }

      const Discretization                     &discretization;
      ElementMatrices                           element;
      ElasticTensor                             law;
      Vector3                                   axis;
      std::vector<Discretization::CellIterator> cells;
      std::vector<CellRows>                     rows;
    };

    /** The displacements of the degrees of freedom of a cell. */
    Eigen::VectorXd
    displacements_of_cell(const CellRows        &rows,
                          const Eigen::VectorXd &local,
                          const unsigned int     n_dofs)
    {
      const Eigen::VectorXd unknowns = local(rows.rows);
      if (!rows.simple)
        return rows.T * unknowns;
      Eigen::VectorXd result = Eigen::VectorXd::Zero(n_dofs);
      for (std::size_t a = 0; a < rows.rows.size(); ++a)
        result[rows.source[a]] = unknowns[a];
      return result;
    }

    void
    add_of_cell(const CellRows        &rows,
                const Eigen::VectorXd &of_dofs,
                Eigen::MatrixXd       &local)
    {
      if (rows.simple)
        for (std::size_t a = 0; a < rows.rows.size(); ++a)
          local(rows.rows[a], 0) += of_dofs[rows.source[a]];
      else
        {
          const Eigen::VectorXd sum = rows.T.transpose() * of_dofs;
          for (std::size_t a = 0; a < rows.rows.size(); ++a)
            local(rows.rows[a], 0) += sum[a];
        }
    }

    /** The stiffness with which the body is held where nothing else holds it, a
     * millionth of that of its breathing, for density 1: 1/s^2. */
    double
    holding(const TurningBody &turning)
    {
      double square = 0.;
      for (const auto &cell : turning.cells)
        for (const unsigned int v : cell->vertex_indices())
          {
            const double x = cell->vertex(v)[0] - turning.axis[0],
                         y = cell->vertex(v)[1] - turning.axis[1];
            square         = std::max(square, x * x + y * y);
          }
      MPI_Allreduce(MPI_IN_PLACE,
                    &square,
                    1,
                    MPI_DOUBLE,
                    MPI_MAX,
                    turning.discretization.space()->communicator());
      const auto &C = turning.law; // shear moduli of yz, zx and xy
      return 1e-6 * std::min({C[5][5], C[2][2], C[1][1]}) / square;
    }

    /** Unit diagonal of the unknowns that the body does not have. */
    void
    add_rows_of_others(const TurningBody &turning, Triplets &lower)
    {
      const RowSpace &space = *turning.discretization.space();
      Eigen::MatrixXd local = Eigen::MatrixXd::Zero(space.n_local(), 1);
      for (const auto &cell : turning.rows)
        for (const int row : cell.rows)
          local(row, 0) = 1.;
      const Block cells = space.scatter_add(local);
      for (Eigen::Index i = 0; i < cells.rows(); ++i)
        if (cells(i, 0) == 0.)
          {
            const int row = static_cast<int>(space.first_owned() + i);
            lower.add(row, row, 1.);
          }
    }

    /** Displacements under the centrifugal forces, with the ghost rows. */
    Eigen::VectorXd
    centrifugal_displacements(TurningBody &turning)
    {
      const auto      space = turning.discretization.space();
      PatternedMatrix K(space, turning.rows, false),
        M(space, turning.rows, true);
      Eigen::MatrixXd matrix,
        local = Eigen::MatrixXd::Zero(space->n_local(), 1);
      for (std::size_t c = 0; c < turning.cells.size(); ++c)
        {
          turning.element.reinit(turning.cells[c]);
          turning.element.stiffness(turning.law, matrix);
          K.add(turning.rows[c], matrix);
          turning.element.mass(matrix);
          M.add(turning.rows[c], matrix);
          add_of_cell(
            turning.rows[c],
            turning.element.centrifugal_load(turning.axis[0], turning.axis[1]),
            local);
        }
      const Block  load      = space->scatter_add(local);
      const auto   stiffness = K.finish(), mass = M.finish();
      const double held = holding(turning);
      Triplets     lower;
      stiffness->append_to(lower, 1., true);
      mass->append_to(lower, held, true);
      add_rows_of_others(turning, lower);
      MumpsFactorization<double> factor(
        space, MumpsFactorization<double>::Symmetry::symmetric);
      factor.factorize(std::move(lower.rows),
                       std::move(lower.columns),
                       std::move(lower.values));
      // Every pass takes the holding out of what deforms the body.
      Block u = factor.solve(load);
      for (int pass = 0; pass < 3; ++pass)
        u = factor.solve(Block(load + held * mass->multiply(u)));
      return space->gather(u).col(0);
    }
  } // namespace



  std::shared_ptr<const SparseMatrix>
  centrifugal_stress_stiffness(const Discretization &d, const unsigned int body)
  {
    TurningBody           turning(d, body);
    const Eigen::VectorXd u = centrifugal_displacements(turning);
    PatternedMatrix       S(d.space(), turning.rows, true);
    Eigen::MatrixXd       matrix;
    for (std::size_t c = 0; c < turning.cells.size(); ++c)
      {
        turning.element.reinit(turning.cells[c]);
        turning.element.stress_stiffness(
          turning.law,
          displacements_of_cell(
            turning.rows[c], u, d.dof_handler().get_fe().n_dofs_per_cell()),
          matrix);
        S.add(turning.rows[c], matrix);
      }
    return S.finish();
  }
} // namespace squeal
