// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_results_open_growth_h
#define squeal_results_open_growth_h

#include <cmath>

namespace squeal
{
  /** Whether the mesh leaves open if a pair of @p frequency (Hz) grows: @p error
   * (1/s, of either sign), that of its growth rate @p sigma (1/s) by the mesh,
   * is no smaller than that and more than rounding beside its frequency, as it
   * is not without damping and friction. False where @p error is NaN. */
  inline bool
  is_growth_open(const double sigma, const double error, const double frequency)
  {
    constexpr double rounding = 1e-8; // of |omega|
    return std::abs(error) > rounding * 2. * M_PI * frequency &&
           std::abs(error) >= std::abs(sigma);
  }
} // namespace squeal

#endif
