// SPDX-License-Identifier: LGPL-2.1-or-later

// Whether the samples that the criteria look at hold what the history does.

#include <squeal/base/number_text.h>
#include <squeal/tribology/damage/subsurface.h>

#include <algorithm>

namespace squeal::tribology
{
  namespace
  {
    /** Parts of the largest range that samples may leave out. */
    constexpr double accepted_loss = .02;

    /** Ranges of both tractions and of the pressure of each node over a window,
     * Pa: three for a node. */
    std::vector<double>
    traction_ranges(const HistoryReader &reader,
                    const HistoryWindow &window,
                    const std::size_t    n_chunk)
    {
      const std::size_t   n = 3 * reader.layout().n_nodes();
      std::vector<double> lowest(n, 1e300), highest(n, -1e300);
      for_each_chunk(reader, window, n_chunk, [&](const HistorySamples &s) {
        for (std::size_t i = 0; i < s.n_samples() * n; ++i)
          {
            const std::size_t at = i / 3, c = i % 3;
            const double      value =
              c < 2 ? s.traction[2 * at + c] : s.pressure[at];
            lowest[i % n]  = std::min(lowest[i % n], value);
            highest[i % n] = std::max(highest[i % n], value);
          }
      });
      for (std::size_t k = 0; k < n; ++k)
        highest[k] -= lowest[k];
      return highest;
    }
  } // namespace



  HistoryWindow
  subsurface_window(const HistoryWindow &window, const SubsurfaceParameters &p)
  {
    const std::uint64_t n = std::min<std::uint64_t>(p.n_samples, window.n);
    return {window.first + window.n - n, n};
  }



  std::string
  note_on_subsurface_window(const HistoryReader        &reader,
                            const HistoryWindow        &window,
                            const SubsurfaceParameters &p,
                            const std::size_t           n_chunk)
  {
    const HistoryWindow seen = subsurface_window(window, p);
    if (seen.n == window.n)
      return "";
    const std::vector<double> all  = traction_ranges(reader, window, n_chunk),
                              part = traction_ranges(reader, seen, n_chunk);
    std::size_t worst              = 0;
    double      largest            = 0.;
    for (std::size_t k = 0; k < all.size(); ++k)
      {
        largest = std::max(largest, all[k]);
        if (all[k] - part[k] > all[worst] - part[worst])
          worst = k;
      }
    if (!(all[worst] - part[worst] > accepted_loss * largest))
      return "";
    return "the criteria below the face look at the last " +
           std::to_string(seen.n) + " of " + std::to_string(window.n) +
           " samples, in which the " +
           (worst % 3 == 2 ? "pressure" : "traction") + " of node " +
           std::to_string(worst / 3) + " varies by " +
           rounded_text(1e-6 * part[worst], 3) + " of " +
           rounded_text(1e-6 * all[worst], 3) +
           " MPa: raise 'Subsurface/Samples' to hold whole periods of what "
           "matters, or set 'History/Start time' and 'End time'";
  }
} // namespace squeal::tribology
