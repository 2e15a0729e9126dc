// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_cycle_orbit_forces_h
#define squeal_cycle_orbit_forces_h

#include <squeal/cycle/orbit.h>

namespace squeal
{
  /** Sums of the nodal forces after every step, N: normal, along and across the
   * sliding, x steps. */
  Eigen::MatrixXd resultants_of(const Orbit &orbit);

  /** The frequency of a motion by the line spectrum of its normal resultant, of
   * the tangential one where that is constant. */
  struct OrbitLine
  {
    double frequency  = 0.; /**< Hz; 0: there is no line */
    double repetition = 0.; /**< as repetition() of a signal */
  };

  /** Between @p lowest and @p highest, Hz; as Spectrum::fundamental(). */
  OrbitLine line_of(const Orbit &orbit,
                    const double lowest,
                    const double highest);
} // namespace squeal

#endif
