// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_source_eigen_mode_coupling_h
#define squeal_source_eigen_mode_coupling_h

#include <squeal/eigen/undamped_modes.h>

namespace squeal
{
  /**
   * How far X^T M X is from 1 and X^T K X from omega^2 of the first @p n modes,
   * relative; NaN where one of them is. A residual K x - omega^2 M x tells
   * less: a trace of a stiff motion, which is no error of the mode, makes it
   * large.
   * Rigid motions are measured by a hundredth of @p limit, a size of omega^2.
   */
  double worst_coupling(const UndampedModes &modes,
                        const unsigned int   n,
                        const double         limit,
                        const RowSpace      &space);
} // namespace squeal

#endif
