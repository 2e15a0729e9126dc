// SPDX-License-Identifier: LGPL-2.1-or-later

// Which pairs of a tracked line may leave or enter its frequency band.

#include "edge_of_band.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace squeal
{
  namespace
  {
    /** Of the highest frequency: what a free motion has by rounding. */
    constexpr double free_motion = 1e-4;
    /** Of the |lambda| from which pairs are left out. */
    constexpr double nearly_left_out = 0.95;
    /** Of the highest frequency: a pair that close to an edge is on it. */
    constexpr double on_the_edge = 1e-9;

    enum BandEdge
    {
      lower_edge,
      upper_edge,
      no_edge
    };

    /** The edge that a frequency reaches with a @p change, Hz. At 0 Hz pairs
     * become real; there is nothing to leave by. */
    BandEdge
    edge_reached(const double           frequency,
                 const double           change,
                 const TrackingOptions &options)
    {
      const double slack   = on_the_edge * options.highest_frequency;
      const double reached = frequency + change;
      if (options.lowest_frequency > 0. &&
          reached < options.lowest_frequency + slack)
        return lower_edge;
      return reached > options.highest_frequency - slack ? upper_edge : no_edge;
    }

    /** The pair of the first point that turns into pair @p i of the second, or
     * -1. */
    int
    pair_before(const PairMatches &matches, const int i)
    {
      const auto found = std::find(matches.to.begin(), matches.to.end(), i);
      return found == matches.to.end()
               ? -1
               : static_cast<int>(found - matches.to.begin());
    }

    /** By how much the frequency of pair @p i of @p here changes up to @p to if
     * it goes on as from pair @p k of @p from, Hz; 0 where k is -1. */
    double
    change_ahead(const TrackedPoint &from,
                 const int           k,
                 const TrackedPoint &here,
                 const int           i,
                 const TrackedPoint &to)
    {
      if (k < 0)
        return 0.;
      return (here.pairs.frequency(i) - from.pairs.frequency(k)) *
             (to.coordinate - here.coordinate) /
             (here.coordinate - from.coordinate);
    }
  } // namespace



  bool
  comes_and_goes(const ComplexPairs    &pairs,
                 const int              i,
                 const TrackingOptions &options)
  {
    const double top = 2. * M_PI * options.highest_frequency;
    if (is_real(pairs, i))
      return pairs.sigma(i) <= 0. || pairs.sigma(i) >= top;
    const double size = std::abs(pairs.lambda[i]);
    return size < free_motion * top ||
           (pairs.sigma(i) < 0. && size > nearly_left_out * 2. * top);
  }



  bool
  ends_at_edges(const std::vector<TrackedPoint> &points,
                const std::vector<PairMatches>  &matches,
                const std::size_t                step,
                const TrackingOptions           &options)
  {
    const TrackedPoint &a = points[step], &b = points[step + 1];
    const PairMatches  &match   = matches[step];
    std::array<bool, 3> leaving = {}, entering = {};
    for (unsigned int i = 0; i < a.pairs.size(); ++i)
      {
        if (match.to[i] >= 0 || comes_and_goes(a.pairs, i, options))
          continue;
        const bool   is_first = step == 0;
        const double change =
          is_first
            ? 0.
            : change_ahead(
                points[step - 1], pair_before(matches[step - 1], i), a, i, b);
        leaving[edge_reached(a.pairs.frequency(i), change, options)] = true;
      }
    for (unsigned int j = 0; j < b.pairs.size(); ++j)
      {
        if (pair_before(match, j) >= 0 || comes_and_goes(b.pairs, j, options))
          continue;
        const bool   is_last = step + 1 == matches.size();
        const double change =
          is_last
            ? 0.
            : change_ahead(points[step + 2], matches[step + 1].to[j], b, j, a);
        entering[edge_reached(b.pairs.frequency(j), change, options)] = true;
      }
    return !leaving[no_edge] && !entering[no_edge] &&
           !(leaving[lower_edge] && entering[lower_edge]) &&
           !(leaving[upper_edge] && entering[upper_edge]);
  }
} // namespace squeal
