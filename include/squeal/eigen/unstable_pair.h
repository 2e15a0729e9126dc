// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_eigen_unstable_pair_h
#define squeal_eigen_unstable_pair_h

#include <squeal/eigen/complex_pairs.h>

namespace squeal
{
  /** What the sigma of a pair is known to, 1/s: its error estimate or, where
   * there is none, what residual and condition leave open; no less than what
   * rounding makes of an undamped pair. */
  double sigma_error(const ComplexPairs &pairs, const unsigned int i);

  /** True where sigma exceeds sigma_error(). */
  bool is_unstable(const ComplexPairs &pairs, const unsigned int i);
} // namespace squeal

#endif
