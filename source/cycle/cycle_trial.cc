// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/cycle/cycle_trial.h>

#include <algorithm>
#include <cmath>

namespace squeal
{
  namespace
  {
    /** A motion is that of a cycle within these shares, in so many parts of so
     * many shortest periods of the cycle. */
    constexpr double       line_share = 0.01, rms_share = 0.05;
    constexpr unsigned int n_trials_held = 4, periods_of_trial = 12;
  } // namespace



  CycleTrials::CycleTrials(const PeriodMap    &m,
                           const CycleFigures &c,
                           const double        dt,
                           const double        last)
    : map(m)
    , cycle(c)
    , step(dt)
    , longest(last)
    , shortest_period(1. / (c.repetitions() * c.frequency))
  {
  }



  MotionTrial
  CycleTrials::follow(const std::string &name, const MotionPlace &start) const
  {
    MotionTrial  result;
    unsigned int n_held    = 0;
    result.start           = name;
    const double frequency = 1. / shortest_period;
    LeadingRun   run(map,
                   start,
                   step,
                   periods_of_trial * shortest_period,
                   longest,
                   .45 * shortest_period);
    try
      {
        for (bool goes_on = true; goes_on && n_held < n_trials_held;)
          {
            goes_on        = run.advance();
            result.figures = run.figures();
            const double harmonic =
              std::max(1., std::round(result.figures.line / frequency));
            result.frequency = result.figures.line / harmonic;
            const bool is_there =
              std::abs(result.frequency - frequency) <=
                line_share * frequency &&
              std::abs(result.figures.rms_normal - cycle.rms_normal) <=
                rms_share * cycle.rms_normal;
            n_held = is_there ? n_held + 1 : 0;
          }
        result.ends_in = n_held >= n_trials_held;
      }
    catch (const ComputationError &)
      {
        result.has_failed = true;
      }
    result.time = start.time + result.figures.time;
    return result;
  }

  MotionTrial
  CycleTrials::follow_cycle(const PeriodicMotion &motion) const
  {
    return follow("the cycle",
                  {motion.orbit.states.front(), motion.orbit.past, 0.});
  }
} // namespace squeal
