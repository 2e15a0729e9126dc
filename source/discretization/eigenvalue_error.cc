// SPDX-License-Identifier: LGPL-2.1-or-later
#include "eigenvalue_error_cell.h"

#include <squeal/discretization/eigenvalue_error.h>

#include <deal.II/distributed/tria.h>

#include <deal.II/fe/mapping.h>

#include <algorithm>
#include <cmath>

namespace squeal
{
  namespace
  {
    using Cell  = Discretization::CellIterator;
    using Force = CellErrorProblem::Force;

    /** The forces in each cell that this rank knows. */
    struct ForcesInCells
    {
      std::vector<std::vector<Force>> forces;
      std::vector<bool> pointwise; /**< cells too small to smooth them out */
    };

    /** Unit coordinates of a point of @p cell; false if it lies outside. */
    bool
    find_in_cell(const Discretization   &d,
                 const Cell             &cell,
                 const dealii::Point<3> &point,
                 dealii::Point<3>       &unit)
    {
      try
        {
          unit = d.mapping().transform_real_to_unit_cell(cell, point);
        }
      catch (const dealii::Mapping<3, 3>::ExcTransformationFailed &)
        {
          return false;
        }
      for (unsigned int c = 0; c < 3; ++c)
        if (unit[c] < -1e-6 || unit[c] > 1. + 1e-6)
          return false;
      return true;
    }

    /** A point on common faces acts on all their cells in equal parts. */
    ForcesInCells
    distribute(const Discretization           &d,
               const std::vector<PointForces> &all_forces)
    {
      const unsigned int n_cells = d.triangulation().n_active_cells();
      ForcesInCells      result{std::vector<std::vector<Force>>(n_cells),
                           std::vector<bool>(n_cells, false)};
      for (const auto &set : all_forces)
        {
          struct Hit
          {
            unsigned int     cell, point;
            dealii::Point<3> unit;
          };
          std::vector<Hit> hits;
          Eigen::MatrixXd  n_holders =
            Eigen::MatrixXd::Zero(set.points.size(), 1);
          dealii::Point<3> unit;
          for (const auto &cell : d.dof_handler().active_cell_iterators())
            {
              if (cell->is_artificial() || cell->material_id() != set.body)
                continue;
              const unsigned int k        = cell->active_cell_index();
              const double       diameter = cell->diameter();
              const auto         centre   = cell->center();
              const bool         small =
                diameter / std::sqrt(3.) < d.degree() * set.spacing;
              for (unsigned int p = 0; p < set.points.size(); ++p)
                if (set.points[p].distance(centre) < diameter &&
                    find_in_cell(d, cell, set.points[p], unit))
                  {
                    if (small)
                      result.pointwise[k] = true;
                    if (cell->is_locally_owned())
                      {
                        hits.push_back({k, p, unit});
                        n_holders(p, 0) += 1.;
                      }
                  }
            }
          d.space()->sum(n_holders);
          for (const auto &hit : hits)
            result.forces[hit.cell].push_back(
              {hit.unit,
               set.forces.middleRows(3 * hit.point, 3) /
                 n_holders(hit.point, 0)});
        }
      return result;
    }

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

    const ForcesInCells in_cells = distribute(d, forces);
    // What one degree more gains, times what all higher ones gain over it.
    const Eigen::VectorXd scale =
      0.5 * (d.degree() + 1.) * relative_scale(omega_squared);
    CellErrorProblem   problem(d, modes, omega_squared);
    const unsigned int n_cells = d.triangulation().n_active_cells();
    Eigen::MatrixXd    errors  = Eigen::MatrixXd::Zero(n_modes, n_cells);
    Eigen::MatrixXd    sums    = Eigen::MatrixXd::Zero(n_modes, 2);
    for (const auto &cell : d.dof_handler().active_cell_iterators())
      if (cell->is_locally_owned())
        {
          const unsigned int    k = cell->active_cell_index();
          const Eigen::VectorXd part =
            problem.energies(cell, in_cells.forces[k], in_cells.pointwise)
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
