// SPDX-License-Identifier: LGPL-2.1-or-later

// Where unstable ranges end: edges, and where a branch leaves the band.

#include <squeal/sweep/stability.h>

#include "certain_sigma.h"

#include <algorithm>
#include <cmath>

namespace squeal
{
  double
  LineStability::edge(const TrackedPoint &a,
                      const TrackedPoint &b,
                      const int           branch,
                      double             &slope) const
  {
    const int i = a.pair_of(branch), j = b.pair_of(branch);
    double    x0 = a.coordinate, x1 = b.coordinate;
    double    s0 = certain_sigma(a.pairs, i), s1 = certain_sigma(b.pairs, j);
    // The end inside the range leads: the branch is distinct there.
    const TrackedPoint &inside = s0 > 0. ? a : b;
    const int           pair   = s0 > 0. ? i : j;
    for (unsigned int step = 0; std::abs(x1 - x0) > tolerance && step < 80;
         ++step)
      {
        // Secant steps kept away from the ends; every third one halves.
        double share   = s0 / (s0 - s1);
        share          = step % 3 == 2 ? 0.5 : std::clamp(share, 0.02, 0.98);
        const double x = x0 + share * (x1 - x0);
        const double value = continue_pair(inside, pair, x).sigma();
        if ((value > 0.) == (s0 > 0.))
          {
            x0 = x;
            s0 = value;
          }
        else
          {
            x1 = x;
            s1 = value;
          }
        if (s0 == s1)
          break;
      }
    slope = (s1 - s0) / (x1 - x0);
    return x0 + s0 / (s0 - s1) * (x1 - x0);
  }



  double
  LineStability::end_in_band(const TrackedPoint &inside,
                             const TrackedPoint &outside,
                             const int           branch,
                             double             &slope) const
  {
    slope = std::nan("");
    // Between a state and its neighbour the problem is known of neither.
    if (!may_peak_between(inside, outside))
      return inside.coordinate;
    TrackedPoint last = inside;
    double       lost = outside.coordinate;
    for (unsigned int step = 0;
         std::abs(lost - last.coordinate) > tolerance && step < 80;
         ++step)
      {
        TrackedPoint here;
        here.coordinate = 0.5 * (last.coordinate + lost);
        here.pairs      = solver(here.coordinate);
        const int pair =
          match_pairs(last.pairs, here.pairs, options).to[last.pair_of(branch)];
        if (pair < 0)
          {
            lost = here.coordinate;
            continue;
          }
        here.branch.assign(here.pairs.size(), -1);
        here.branch[pair] = branch;
        // It settles before it leaves.
        if (!(certain_sigma(here.pairs, pair) > 0.))
          return inside.coordinate < here.coordinate
                   ? edge(last, here, branch, slope)
                   : edge(here, last, branch, slope);
        last = here;
      }
    return last.coordinate;
  }



  void
  LineStability::find_ends(const std::vector<TrackedPoint> &line,
                           const std::size_t                first,
                           const std::size_t                last,
                           UnstableRange                   &range) const
  {
    const auto settles = [](double &slope) {
      const bool result = !std::isnan(slope);
      if (!result)
        slope = 0.;
      return result;
    };
    if (range.leaves_band_below)
      {
        range.lower = end_in_band(
          line[first], line[first - 1], range.branch, range.lower_slope);
        range.leaves_band_below = !settles(range.lower_slope);
      }
    else if (range.has_lower_edge())
      range.lower =
        edge(line[first - 1], line[first], range.branch, range.lower_slope);
    if (range.leaves_band_above)
      {
        range.upper = end_in_band(
          line[last], line[last + 1], range.branch, range.upper_slope);
        range.leaves_band_above = !settles(range.upper_slope);
      }
    else if (range.has_upper_edge())
      range.upper =
        edge(line[last], line[last + 1], range.branch, range.upper_slope);
  }
} // namespace squeal
