// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/tribology/fatigue/open_contact.h>
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
    /** Of the extremum: beside it a sample that is less is one of an open
     * contact. */
    constexpr double open = 1e-3;
    /** Cosine of the angle between two samples of a sine with 2.6 samples a
     * period. One that stands alone between two others has -1. */
    constexpr double alone = -0.75;
  } // namespace



  PeakSharpener::PeakSharpener(const double exponent)
    : exponent(exponent)
  {
  }



  bool
  PeakSharpener::is_within(const double share) const
  {
    return std::abs(now) <= share * largest;
  }



  double
  PeakSharpener::top(const double next) const
  {
    if (now == before || is_within(rest_of_none))
      return now;
    const double bend = 2. * now - before - next;
    if (was_open)
      return now + (next - before) * (next - before) / (8. * bend);
    double raised = now;
    for (unsigned int i = 0; i < n_iterations; ++i)
      {
        // Of a cos(phi + k alpha) about the middle, k = -1, 0, 1: alpha from
        // the second difference and tan(phi) from the first one, both over the
        // value itself. The highest sample lies within half an interval of the
        // top.
        const double value = now - .5 * (raised + turning);
        const double cosine =
          std::clamp(1. - bend / (2. * value), least_cosine, 1.);
        const double slope  = (next - before) / (2. * value);
        const double square = std::min(slope * slope / (1. - cosine * cosine),
                                       (1. - cosine) / (1. + cosine));
        raised              = now + value * (std::sqrt(1. + square) - 1.);
        if (!std::isfinite(raised))
          return now;
      }
    return raised * now < 0. ? 0. : raised;
  }



  bool
  PeakSharpener::is_unseen(const double next) const
  {
    const auto is_open = [this](const double value) {
      return std::abs(value) <= open * std::abs(now);
    };
    // What is small beside the ranges so far hides nothing.
    if (is_within(open))
      return false;
    // Two equal samples are a pulse of their own, more are a step.
    if (now == before)
      return is_open(earlier) && is_open(next);
    const double cosine = 1. - (2. * now - before - next) / (now - turning);
    return is_open(before) || is_open(next) || cosine < alone;
  }



  void
  PeakSharpener::turn(const double next, const double raised)
  {
    const bool   hides = is_unseen(next);
    const double range = std::abs(raised - turning);
    if (range > largest)
      {
        const double part = std::pow(largest / range, exponent);
        all *= part;
        unseen *= part;
        largest = range;
      }
    if (range > 0.)
      {
        const double power = std::pow(range / largest, exponent);
        all += power;
        unseen += hides || hid ? power : 0.;
      }
    hid      = hides;
    was_open = is_within(rest_of_none);
    turning  = raised;
  }



  double
  PeakSharpener::unseen_share() const
  {
    return all > 0. ? unseen / all : 0.;
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
          {
            turning  = next;
            was_open = next == 0.;
          }
        else
          {
            const int  change = int(next > now) - int(next < now);
            const bool turns  = change * direction < 0;
            sharpened.push_back(turns ? top(next) : now);
            if (turns)
              turn(next, sharpened.back());
            if (change != 0)
              direction = change;
          }
        earlier = before;
        before  = now;
        now     = next;
      }
  }



  void
  PeakSharpener::finish(std::vector<double> &sharpened) const
  {
    if (n_values > 0)
      sharpened.push_back(now);
  }
} // namespace squeal::tribology
