// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_source_sweep_certain_sigma_h
#define squeal_source_sweep_certain_sigma_h

#include <squeal/eigen/complex_pairs.h>

#include <algorithm>
#include <cmath>

namespace squeal
{
  /** Sigma less what rounding makes of it: an undamped pair has one of either
   * sign, a few digits of its condition large. */
  inline double
  certain_sigma(const ComplexPairs &pairs, const int i)
  {
    return pairs.sigma(i) - 1e-14 * std::min(pairs.condition[i], 1e8) *
                              std::abs(pairs.lambda[i]);
  }
} // namespace squeal

#endif
