// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_source_results_compare_summary_h
#define squeal_source_results_compare_summary_h

#include <squeal/results/compare.h>

#include <iosfwd>

namespace squeal
{
  /** Lines that a comparison prints at most unless all is asked for. */
  constexpr std::size_t most_compared_lines = 40;

  /** Prints what is to be known before the pairs are read, a line of 80 columns
   * each: that sweeps have other axes, and why shapes are not compared where
   * both runs have signatures that do not fit each other. @p parameters: as of
   * print_summary(). */
  void print_reservations(const RunComparison &comparison,
                          const Table         *parameters,
                          std::ostream        &out);

  /** Prints what matters of a comparison of two runs in at most
   * most_compared_lines less the two that name the runs. @p parameters that
   * differ: "parameter", "A", "B"; null where they are not known. */
  void print_summary(const RunComparison &comparison,
                     const Table         *parameters,
                     std::ostream        &out);
} // namespace squeal

#endif
