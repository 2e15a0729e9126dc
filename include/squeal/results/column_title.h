// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_results_column_title_h
#define squeal_results_column_title_h

#include <squeal/results/table.h>

#include <string>

namespace squeal
{
  /** The name of a column in words, without those of its unit, and the unit:
   * "growth rate" and "1/s" of growth_rate_per_s. */
  struct ColumnTitle
  {
    explicit ColumnTitle(const Table::Column &column);

    std::string name, unit;

    /** "growth rate in 1/s", for the axis of a chart. */
    std::string of_axis() const;

    /** "growth rate 210 1/s", four digits. */
    std::string with(const double value) const;
  };
} // namespace squeal

#endif
