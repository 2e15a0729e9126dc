// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_transient_common_period_h
#define squeal_transient_common_period_h

#include <limits>
#include <vector>

namespace squeal
{
  /** One of several signals of a motion, without its mean and its drift. */
  struct MotionSignal
  {
    std::vector<double>
      values; /**< in the unit of all signals, equally apart */
    /** It is that of a place, which may move on its own: it counts only where
     * it has a period. */
    bool is_local = false;
  };

  /** The period of a motion. */
  struct CommonPeriod
  {
    double frequency = 0.; /**< Hz; 0: there is no line */
    /** Largest deviation of its quarters, Hz; NaN if none has a line. */
    double frequency_ci = std::numeric_limits<double>::quiet_NaN();
    /** Of the first signal, of the loudest one where that tells the frequency;
     * Hz. */
    double largest_line = 0.;
    /** repetition() of the first signal; where the period is not that of the
     * first one alone, the least of those that count. */
    double repetition = 0.;
  };

  /**
   * The shortest period of the first of @p signals, Spectrum::fundamental(),
   * after which the others come back as well: of a motion that goes round, the
   * sum over all places has a shorter one. Others count from 5 % of the first
   * one's mean square on. Of a first signal that repeats itself beside others
   * with which it has no period in common, the loudest tells the frequency.
   *
   * @param interval  between values, s
   * @param lowest    line that counts, Hz
   * @param highest   line that counts, Hz
   */
  CommonPeriod common_period(const std::vector<MotionSignal> &signals,
                             const double                     interval,
                             const double                     lowest,
                             const double                     highest);
} // namespace squeal

#endif
