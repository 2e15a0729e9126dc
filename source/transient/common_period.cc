// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/transient/common_period.h>
#include <squeal/transient/spectrum.h>

#include <algorithm>
#include <cmath>

namespace squeal
{
  namespace
  {
    /** Periods that count, of the longest one of a signal: as in
     * Spectrum::fundamental(). */
    constexpr unsigned int most_multiples = 4;

    /** Share by which two frequencies of one line may differ: of one that is
     * modulated, lines lie beside it. */
    constexpr double same_line = 0.05;

    /** A signal between two frequencies and what its own lines tell. */
    struct SignalLines
    {
      SignalLines(const std::vector<double> &signal,
                  const double               interval,
                  const double               from,
                  const double               to)
        : values(signal)
        , spectrum(power_spectrum(signal, interval))
        , lowest(from)
        , highest(to)
        , power(spectrum.power(lowest, highest))
        , largest(spectrum.peak(lowest, highest))
        , own(spectrum.fundamental(lowest, highest))
        , best(own > 0. ? spectrum.correlation(own, lowest, highest) : 0.)
      {
      }

      bool
      is_periodic() const
      {
        return best >= 1. - most_aperiodic;
      }

      /** Whether it comes back a period of @p f later, almost as well as after
       * its own. What is slow has hardly moved on after a time shorter than
       * the period of its largest line. */
      bool
      comes_back(const double f) const
      {
        return f <= (1. + same_line) * largest &&
               spectrum.correlation(f, lowest, highest) >=
                 best - most_aperiodic;
      }

      /** Whether the largest line is one of the multiples of @p f, as far as
       * lines can be told apart: in a motion that is modulated lines lie beside
       * them, and it comes back almost as well after the periods of both. */
      bool
      has_multiple(const double f) const
      {
        const double order = std::round(largest / f);
        return std::abs(largest - order * f) <=
               2. * order * spectrum.frequency[1];
      }

      const std::vector<double> &values;
      Spectrum                   spectrum;
      double                     lowest, highest, power, largest, own, best;
    };

    using AllLines = std::vector<SignalLines>;

    bool
    all_come_back(const AllLines &all, const double f)
    {
      return std::all_of(all.begin(), all.end(), [f](const SignalLines &s) {
        return s.comes_back(f);
      });
    }

    /** The first signal and those that count beside it. */
    AllLines
    lines_that_count(const std::vector<MotionSignal> &signals,
                     const double                     interval,
                     const double                     lowest,
                     const double                     highest)
    {
      AllLines result;
      for (const MotionSignal &signal : signals)
        {
          SignalLines next(signal.values, interval, lowest, highest);
          if (result.empty() ||
              (next.own > 0. &&
               next.power >= least_power_share * result.front().power &&
               (next.is_periodic() || !signal.is_local)))
            result.push_back(std::move(next));
        }
      return result;
    }

    /** A frequency and the signal whose largest line tells it. */
    struct ToldFrequency
    {
      double             frequency;
      const SignalLines *by;
      bool               is_common; /**< to all, the first signal as well */
    };

    /** The highest one up to that of the first signal, and of whose multiples
     * its largest line is one, with which all come back; of the loudest signal
     * where there is none. */
    ToldFrequency
    told_by_all(const AllLines &all)
    {
      const SignalLines &first = all.front();
      ToldFrequency      result{0., &first, true};
      for (const SignalLines &s : all)
        for (unsigned int k = 1; k <= most_multiples; ++k)
          if (const double f = s.own / k;
              f > result.frequency && f < first.own && f >= s.lowest &&
              f > 40. * s.spectrum.frequency[1] && first.has_multiple(f) &&
              all_come_back(all, f))
            result = {f, &s, true};
      if (result.frequency > 0.)
        return result;
      for (const SignalLines &s : all)
        if (s.power > result.by->power)
          result.by = &s;
      return {result.by->own, result.by, false};
    }
  } // namespace



  CommonPeriod
  common_period(const std::vector<MotionSignal> &signals,
                const double                     interval,
                const double                     lowest,
                const double                     highest)
  {
    const AllLines all = lines_that_count(signals, interval, lowest, highest);
    const SignalLines &first = all.at(0);
    ToldFrequency      told{first.own, &first, true};
    CommonPeriod       result;
    // What does not repeat itself has no period that others could share.
    const bool is_that_of_first =
      !first.is_periodic() || all_come_back(all, first.own);
    if (!is_that_of_first)
      told = told_by_all(all);
    result.frequency    = told.frequency;
    result.largest_line = told.is_common ? first.largest : told.by->largest;
    result.repetition   = repetition(first.values, interval, told.frequency);
    for (const SignalLines &s : all)
      if (!is_that_of_first)
        result.repetition = std::min(
          result.repetition, repetition(s.values, interval, told.frequency));
    if (told.frequency > 0.)
      result.frequency_ci =
        line_deviation(told.by->values, interval, told.by->largest) /
        std::round(told.by->largest / told.frequency);
    return result;
  }
} // namespace squeal
