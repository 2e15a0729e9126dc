// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_source_sweep_edge_of_band_h
#define squeal_source_sweep_edge_of_band_h

#include <squeal/sweep/branch_tracker.h>

#include <vector>

namespace squeal
{
  /**
   * Whether pair @p i may be without partner at the next point wherever its
   * frequency is: real eigenvalues that decay, or that grow faster than the
   * band is high; pairs that decay so fast that they are about to be left out;
   * and free motions, which oscillate by rounding only.
   */
  bool comes_and_goes(const ComplexPairs    &pairs,
                      const int              i,
                      const TrackingOptions &options);

  /**
   * Whether every pair without partner between points @p step and @p step + 1
   * crosses an edge of the band there: its frequency, extrapolated over the
   * step from the change to the point on its other side, must reach the edge.
   * False where that change is not known, and where one pair seems to leave
   * and another one to enter by the same edge: they may be the same.
   * @p matches: one for each step.
   */
  bool ends_at_edges(const std::vector<TrackedPoint> &points,
                     const std::vector<PairMatches>  &matches,
                     const std::size_t                step,
                     const TrackingOptions           &options);
} // namespace squeal

#endif
