// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/cycle/cycle_trial.h>

#include <algorithm>
#include <cmath>

namespace squeal
{
  namespace
  {
    /** A motion is that of a cycle within these shares beside the errors of
     * the cycle, and never farther off than the wide ones. */
    constexpr double line_share = 1e-3, rms_share = 0.01,
                     wide_line_share = 0.01, wide_rms_share = 0.05;
    /** Parts of so many shortest periods; so many at least are judged. */
    constexpr unsigned int least_parts = 4, periods_of_trial = 12;
    /** A disturbance has grown clearly where it is so many times as large; that
     * is waited for over so many periods at most. */
    constexpr double clear_growth = 100., most_periods = 480.;

    /** Periods in which a disturbance would grow clearly if the largest
     * multiplier is as large as its error allows. */
    double
    periods_of_growth(const FloquetMultipliers &multipliers)
    {
      const double largest = multipliers.largest + multipliers.uncertainty();
      return largest > 1. ? std::min(most_periods,
                                     std::log(clear_growth) / std::log(largest))
                          : 0.;
    }

    /** Shares are of @p size. */
    bool
    is_near(const double value,
            const double expected,
            const double size,
            const double share,
            const double wide_share,
            const double error)
    {
      return std::abs(value - expected) <=
             std::min(share * size + error, wide_share * size);
    }
  } // namespace



  CycleTrials::CycleTrials(const PeriodMap   &m,
                           const CycleResult &c,
                           const double       dt,
                           const double       last)
    : map(m)
    , cycle(c)
    , step(dt)
    , shortest_period(1. / (c.figures.repetitions() * c.figures.frequency))
    , n_parts(std::max<unsigned int>(
        least_parts,
        static_cast<unsigned int>(std::ceil(
          periods_of_growth(c.multipliers) /
          (c.figures.frequency * periods_of_trial * shortest_period)))))
    , longest(last +
              (n_parts - least_parts) * periods_of_trial * shortest_period)
  {
  }



  bool
  CycleTrials::is_there(const MotionTrial &trial) const
  {
    const double              times  = cycle.figures.repetitions();
    const std::vector<double> pairs  = cycle.figures.rms_of_pairs(),
                              coarse = cycle.coarse_figures.rms_of_pairs();
    bool result                      = is_near(trial.frequency,
                          1. / shortest_period,
                          1. / shortest_period,
                          line_share,
                          wide_line_share,
                          times * cycle.frequency_error());
    for (std::size_t p = 0; p < pairs.size(); ++p)
      result = result && is_near(trial.figures.rms_of_pairs[p],
                                 pairs[p],
                                 cycle.figures.rms_normal,
                                 rms_share,
                                 wide_rms_share,
                                 error_by_steps(pairs[p], coarse[p]));
    return result;
  }

  MotionTrial
  CycleTrials::follow(const std::string &name, const MotionPlace &start) const
  {
    MotionTrial  result;
    unsigned int n_held    = 0;
    result.start           = name;
    const double frequency = 1. / shortest_period,
                 part      = periods_of_trial * shortest_period;
    LeadingRun run(map, start, step, part, longest, .45 * shortest_period);
    try
      {
        for (bool goes_on = true; goes_on && n_held < n_parts;)
          {
            goes_on        = run.advance();
            result.figures = run.figures(cycle.figures.judged_rows());
            const double harmonic =
              std::max(1., std::round(result.figures.line / frequency));
            result.frequency = result.figures.line / harmonic;
            n_held           = is_there(result) ? n_held + 1 : 0;
          }
        result.ends_in = n_held >= n_parts;
      }
    catch (const ComputationError &)
      {
        result.has_failed = true;
      }
    result.periods =
      double(n_held * periods_of_trial) / cycle.figures.repetitions();
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
