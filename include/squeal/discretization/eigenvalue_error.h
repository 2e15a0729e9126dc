// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_discretization_eigenvalue_error_h
#define squeal_discretization_eigenvalue_error_h

#include <squeal/discretization/discretization.h>

#include <Eigen/Core>

#include <limits>
#include <vector>

namespace squeal
{
  /** Forces that modes exert on a body through point springs or contact. */
  struct PointForces
  {
    unsigned int                   body = 0;
    std::vector<dealii::Point<3>>  points; /**< m */
    /** (3 n_points) x n_modes: x, y, z of the first point, then the second;
     * N for the modes as they are scaled. */
    Eigen::MatrixXd forces;
    /** Distance of neighbouring points, m; a lone point has none. */
    double spacing = std::numeric_limits<double>::infinity();
  };

  /** Estimated discretisation errors of modes. */
  struct ModeErrors
  {
    /** For every active cell (zero on cells of other ranks) the estimated
     * relative errors of omega^2 that arise there, summed over the modes. */
    std::vector<double> cell;
    /** (omega_h^2 - omega^2) / omega^2 of every mode; half of it is the
     * relative error of the frequency. */
    Eigen::VectorXd mode;
  };

  ModeErrors
  estimate_mode_errors(const Discretization           &discretization,
                       const Block                    &modes,
                       const Eigen::VectorXd          &omega_squared,
                       const std::vector<PointForces> &forces = {});
} // namespace squeal

#endif
