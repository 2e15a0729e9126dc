// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/tribology/fatigue/peak_sharpener.h>

#include <algorithm>
#include <cmath>

namespace squeal::tribology
{
  namespace
  {
    /** Cosine of the largest angle between two samples of a sine, which has
     * three a period: with fewer, as in noise, three samples tell no amplitude.
     */
    constexpr double least_cosine = -0.5;
    /** For the middle between an extremum and the one before: three find the
     * amplitude of a sine with four samples a period to 0.1 %. */
    constexpr unsigned int n_iterations = 3;
  } // namespace



  double
  PeakSharpener::top(const double next) const
  {
    if (now == before || now == 0.)
      return now;
    double raised = now;
    for (unsigned int i = 0; i < n_iterations; ++i)
      {
        // Of a cos(phi + k alpha) about the middle, k = -1, 0, 1: alpha from
        // the second difference and tan(phi) from the first one, both over the
        // value itself. The highest sample lies within half an interval of the
        // top.
        const double value  = now - .5 * (raised + turning);
        const double cosine = std::clamp(
          1. - (2. * now - before - next) / (2. * value), least_cosine, 1.);
        const double slope  = (next - before) / (2. * value);
        const double square = std::min(slope * slope / (1. - cosine * cosine),
                                       (1. - cosine) / (1. + cosine));
        raised              = now + value * (std::sqrt(1. + square) - 1.);
        if (!std::isfinite(raised))
          return now;
      }
    return raised * now < 0. ? 0. : raised;
  }



  void
  PeakSharpener::add(const double        *values,
                     const std::size_t    n,
                     std::vector<double> &sharpened)
  {
    for (std::size_t i = 0; i < n; ++i)
      {
        const double next = values[i];
        if (n_values++ == 0)
          turning = next;
        else
          {
            const int  change = int(next > now) - int(next < now);
            const bool turns  = change * direction < 0;
            sharpened.push_back(turns ? top(next) : now);
            if (turns)
              turning = sharpened.back();
            if (change != 0)
              direction = change;
          }
        before = now;
        now    = next;
      }
  }



  void
  PeakSharpener::finish(std::vector<double> &sharpened) const
  {
    if (n_values > 0)
      sharpened.push_back(now);
  }
} // namespace squeal::tribology
