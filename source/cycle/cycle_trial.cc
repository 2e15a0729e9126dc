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
    /** A motion is on its way where its rms changes by more than this share
     * from the first to the last of three parts, so many parts apart. */
    constexpr double least_way = 1e-3;
    /** The line of a motion that grows is that of the pair. */
    constexpr double      line_share_on_its_way = 0.1;
    constexpr std::size_t most_parts_apart      = 3;

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

  bool
  CycleTrials::approaches(const MotionTrial         &trial,
                          const std::vector<double> &rms) const
  {
    if (rms.size() < 3)
      return true; // nothing is told by so few
    if (!is_near(trial.frequency,
                 1. / shortest_period,
                 1. / shortest_period,
                 line_share_on_its_way,
                 line_share_on_its_way,
                 0.))
      return false;
    const std::size_t last  = rms.size() - 1,
                      apart = std::min(most_parts_apart, last / 2);
    const double expected = cycle.figures.rms_of_pairs()[cycle.figures.loudest];
    // So near it may settle, or be a motion that winds about the cycle.
    if (is_near(trial.frequency,
                1. / shortest_period,
                1. / shortest_period,
                wide_line_share,
                wide_line_share,
                0.) &&
        is_near(
          rms[last], expected, expected, wide_rms_share, wide_rms_share, 0.))
      return true;
    const double first   = rms[last - apart] - rms[last - 2 * apart],
                 second  = rms[last] - rms[last - apart],
                 missing = expected - rms[last];
    // Less than that is no way to somewhere.
    const bool goes_there = first * missing > 0. && second * missing > 0. &&
                            std::abs(first + second) > least_way * expected;
    if (!goes_there || std::abs(second) >= std::abs(first))
      return goes_there;
    // As a distance that shrinks by the same factor again and again ends.
    const double ratio = second / first, end = second * ratio / (1. - ratio);
    return std::abs(end) > std::abs(missing) - wide_rms_share * expected;
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
    std::vector<double> rms; // of the cycle's loudest pair, of each part
    try
      {
        // What is there when its time is over stays or leaves soon.
        for (bool goes_on = true; (goes_on || n_held > 0) && n_held < n_parts;)
          {
            goes_on        = run.advance();
            result.figures = run.figures(cycle.figures.judged_rows());
            rms.push_back(result.figures.rms_of_pairs[cycle.figures.loudest]);
            const double harmonic =
              std::max(1., std::round(result.figures.line / frequency));
            result.frequency = result.figures.line / harmonic;
            n_held           = is_there(result) ? n_held + 1 : 0;
          }
        result.ends_in      = n_held >= n_parts;
        result.is_undecided = !result.ends_in && approaches(result, rms);
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
