// SPDX-License-Identifier: LGPL-2.1-or-later
#include "eigenvalue_error_cell.h"
#include "point_forces_in_cells.h"

#include <squeal/discretization/eigenvalue_error.h>

#include <deal.II/distributed/tria.h>

#include <algorithm>
#include <cmath>

namespace squeal
{
  namespace
  {
    /** Factors that make relative errors of f of errors of omega^2. */
    Eigen::VectorXd
    relative_scale(const Eigen::VectorXd &omega_squared)
    {
      const double limit = 1e-9 * omega_squared.cwiseAbs().maxCoeff();
      return omega_squared.unaryExpr(
        [&](const double x) { return x > limit ? 0.5 / x : 0.; });
    }
  } // namespace



  ModeErrors
  estimate_mode_errors(const Discretization           &d,
                       const Block                    &modes,
                       const Eigen::VectorXd          &omega_squared,
                       const std::vector<PointForces> &forces)
  {
    const unsigned int n_modes = modes.cols();
    ModeErrors         result;
    result.frequency = result.at_points = Eigen::VectorXd::Zero(n_modes);
    if (!d.has_mesh() || n_modes == 0)
      return result;

    const ForcesInCells in_cells = forces_in_cells(d, forces);
    // What one degree more gains, times what all higher ones gain over it.
    const Eigen::VectorXd scale =
      0.5 * (d.degree() + 1.) * relative_scale(omega_squared);
    CellErrorProblem::Inertia inertia(n_modes, n_modes);
    for (unsigned int k = 0; k < n_modes; ++k)
      inertia.insert(k, k) = omega_squared[k];
    CellErrorProblem   problem(d, modes, {inertia});
    const unsigned int n_cells = d.triangulation().n_active_cells();
    Eigen::MatrixXd    errors  = Eigen::MatrixXd::Zero(n_modes, n_cells);
    Eigen::MatrixXd    sums    = Eigen::MatrixXd::Zero(n_modes, 2);
    for (const auto &cell : d.dof_handler().active_cell_iterators())
      if (cell->is_locally_owned())
        {
          const unsigned int    k = cell->active_cell_index();
          const Eigen::VectorXd part =
            problem.residuals(cell, in_cells.forces[k], in_cells.pointwise)
              .colwise()
              .squaredNorm()
              .transpose()
              .cwiseProduct(scale);
          sums.col(in_cells.pointwise[k] ? 1 : 0) += part;
          if (!in_cells.pointwise[k])
            errors.col(k) = part;
        }
    d.space()->sum(sums);
    result.frequency = sums.col(0);
    result.at_points = sums.col(1);

    const double largest = result.frequency.maxCoeff();
    result.cell.assign(n_cells, 0.);
    if (largest > 0.)
      Eigen::Map<Eigen::VectorXd>(result.cell.data(), n_cells) =
        errors.transpose() * (result.frequency / largest);
    return result;
  }
} // namespace squeal
