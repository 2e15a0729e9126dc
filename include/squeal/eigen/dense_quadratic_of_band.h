// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_eigen_dense_quadratic_of_band_h
#define squeal_eigen_dense_quadratic_of_band_h

#include <squeal/eigen/dense_quadratic.h>

namespace squeal
{
  /** solve_dense_quadratic() for eigenvalues of a band up to the circular
   * frequency @p highest, rad/s: of a basis with free motions, whose zeros are
   * rounding, this tells them from the rest, which they would otherwise drown.
   */
  DensePairs solve_dense_quadratic_of_band(
    const std::vector<ReducedPart> &parts,
    const bool                      rayleigh,
    const double                    alpha,
    const double                    beta,
    const double                    highest);
} // namespace squeal

#endif
