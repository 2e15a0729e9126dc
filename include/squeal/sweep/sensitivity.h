// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_sweep_sensitivity_h
#define squeal_sweep_sensitivity_h

#include <squeal/eigen/complex_pairs.h>
#include <squeal/sweep/parametric_system.h>
#include <squeal/sweep/reduced_model.h>

namespace squeal
{
  /**
   * dlambda / d ln p = - y^T (lambda^2 dM + lambda dC + dK) x / y^T Q' x of
   * every pair for one entry p of the grid, counted through entries() and
   * other_entries(). Of members of a nearly coalesced pair it grows without
   * bound: see pair_sensitivities().
   *
   * @p pairs hold vectors in the common basis, as solve_point_refined() returns
   * them; from those of solve_point() the derivatives are good to the root of
   * the eigenvalues' error only.
   */
  Eigen::VectorXcd sensitivities(const ReducedModel     &model,
                                 const ParametricSystem &system,
                                 const SweepPoint       &point,
                                 const ComplexPairs     &pairs,
                                 const unsigned int      entry);

  /** Derivatives of the mean and of the squared half-difference of two pairs,
   * which stay finite where they coalesce. */
  struct PairSensitivity
  {
    std::complex<double> mean, square;
  };
  PairSensitivity pair_sensitivity(const ReducedModel     &model,
                                   const ParametricSystem &system,
                                   const SweepPoint       &point,
                                   const ComplexPairs     &pairs,
                                   const unsigned int      entry,
                                   const int               i,
                                   const int               j);
} // namespace squeal

#endif
