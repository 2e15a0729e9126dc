// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_results_marked_series_h
#define squeal_results_marked_series_h

#include <squeal/results/chart.h>

#include <string>

namespace squeal
{
  /** A series without points whose points are drawn by a marker, @p size times
   * as large as usual. */
  inline ChartSeries
  marked_series(const std::string        &label,
                const ChartSeries::Marker marker,
                const double              size,
                const Ink                 ink,
                const bool                hollow)
  {
    ChartSeries s;
    s.label       = label;
    s.marker      = marker;
    s.marker_size = size;
    s.ink         = ink;
    s.hollow      = hollow;
    return s;
  }
} // namespace squeal

#endif
