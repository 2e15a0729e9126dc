// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_eigen_dense_scaling_h
#define squeal_eigen_dense_scaling_h

#include <Eigen/Core>

namespace squeal
{
  /** Scales d of the unknowns that give diag(d) A diag(d) a unit diagonal, for
   * small dense matrices. Directions of a stiff contact have Rayleigh quotients
   * many orders above those of the band: unscaled, their rounding errors would
   * drown the wanted ones. */
  Eigen::VectorXd unit_diagonal_scales(const Eigen::MatrixXd &A);

  /** A square frequency, (rad/s)^2, low in the spectrum of K x = kappa M x:
   * most vectors of an enriched basis are far above the band. */
  double typical_kappa(const Eigen::MatrixXd &K, const Eigen::MatrixXd &M);
} // namespace squeal

#endif
