// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/number_text.h>
#include <squeal/tribology/damage/sample_spacing.h>

#include <algorithm>
#include <cmath>

namespace squeal::tribology
{
  namespace
  {
    /** An interval of more than so many median ones is a pause. */
    constexpr double factor_of_pause = 10.;
    /** Of the mean interval, that even ones may be off it. */
    constexpr double even = 1e-3;
  } // namespace



  void
  SampleSpacing::add(const std::vector<double> &times)
  {
    for (const double time : times)
      {
        if (has_last)
          {
            const double interval = time - last;
            Class &same = classes[int(std::lround(50. * std::log(interval)))];
            ++same.n;
            same.sum += interval;
            ++n_intervals;
            total += interval;
            shortest = std::min(shortest, interval);
            if (interval > longest)
              {
                longest          = interval;
                start_of_longest = last;
              }
          }
        last     = time;
        has_last = true;
      }
  }



  double
  SampleSpacing::median() const
  {
    std::uint64_t below = 0;
    for (const auto &[number, same] : classes)
      {
        below += same.n;
        if (2 * below >= n_intervals)
          return same.sum / same.n;
      }
    return 0.;
  }



  bool
  SampleSpacing::is_even() const
  {
    const double mean = total / n_intervals;
    return longest - mean <= even * mean && mean - shortest <= even * mean;
  }



  std::string
  SampleSpacing::note() const
  {
    const double  middle = median();
    std::uint64_t n      = 0;
    double        paused = 0.;
    for (const auto &[number, same] : classes)
      if (same.sum / same.n > factor_of_pause * middle)
        {
          n += same.n;
          paused += same.sum;
        }
    if (n == 0)
      return "";
    return "no sample for " + rounded_text(longest, 3) + " s after " +
           rounded_text(start_of_longest, 6) + " s, " +
           rounded_text(longest / middle, 3) + " times the median interval" +
           (n > 1 ? " (the longest of " + std::to_string(n) + " pauses)" : "") +
           ": pauses count as time without cycles, so that damage, cycles and "
           "impacts per second are " +
           rounded_text(total / (total - paused), 3) +
           " times lower than without, and integrals over time run straight "
           "through them; set 'History/Start time' and 'End time' to leave "
           "them out";
  }
} // namespace squeal::tribology
