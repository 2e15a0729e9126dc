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
   * most vectors of an enriched basis are far above the band. Directions with
   * quotients below @p least do not count: of free motions they are rounding,
   * and K + kappa M with such a kappa is as good as singular. Where all
   * are below it, all count; 1 where none is positive. */
  double typical_kappa(const Eigen::MatrixXd &K,
                       const Eigen::MatrixXd &M,
                       const double           least = 0.);

  /** What is far below all that a band up to the circular frequency @p highest,
   * rad/s, tells from free motions, for typical_kappa(): (rad/s)^2. */
  double least_kappa(const double highest);
} // namespace squeal

#endif
