// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_output_headline_error_h
#define squeal_output_headline_error_h

#include <squeal/results/table.h>

#include <string>
#include <utility>
#include <vector>

namespace squeal
{
  /** Where an error of a result comes from, and its size in one unit for all
   * of them; NaN: not estimated. */
  using ErrorSource = std::pair<std::string, double>;

  /**
   * The error of a result on the first screen: the largest of its sources by
   * name, "0.12 % (mesh)"; relative errors below 1e-4 and those with a @p unit are
   * written as they are. Sources that are not estimated are named behind it
   * ("mesh error not estimated") and never pass for small.
   */
  std::string headline_error(const std::vector<ErrorSource> &sources,
                             const std::string              &unit = "");

  /** The largest value of a column of errors; NaN where none is known or the
   * table has no such column. Where some rows have none the name says of how
   * many they are known. */
  ErrorSource error_of_column(const std::string &name,
                              const Table       &table,
                              const std::string &column);
} // namespace squeal

#endif
