// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_transient_growth_rule_h
#define squeal_transient_growth_rule_h

#include <squeal/transient/growth.h>

namespace squeal
{
  /** Traces of other motions beat with a pair in about its period: a window
   * that is shorter sees a part of a beat, whose slope neither parts nor halves
   * of the window tell from a rate. */
  constexpr double fewest_periods = 4.;

  /**
   * Whether window and interval of a fit let it stand for a growth rate: the
   * window holds at least `fewest_periods`, and the half width is at most half
   * of the rate, or at most 10 1/s for a pair near the threshold, whose rate
   * may be anything small. A wider one tells the rate to no more than a factor
   * of three, or not even its sign; it comes from amplitudes that are traces of
   * other, larger motions, whose parts of the window give slopes all over the
   * place.
   *
   * The linearised rate is deliberately no part of the rule: a narrow interval
   * beside it is a finding and is shown.
   */
  bool tells_a_rate(const GrowthFit &fit);
} // namespace squeal

#endif
