// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_statistics_table_faults_h
#define squeal_tribology_statistics_table_faults_h

#include <squeal/results/table.h>

#include <string>
#include <vector>

namespace squeal::tribology
{
  /** read_csv() of a table of cells of a pad, which programs write: throws
   * InputError as well where the last line does not end. A table that was cut
   * in its last number would otherwise count with what is left of it. */
  Table read_whole_csv(const std::string                &path,
                       const std::vector<Table::Column> &required);

  /** Throws InputError where a table of features has no rows, or a density of
   * cracks (column "crack_density_per_m", 1/m) that is negative. */
  void require_possible_features(const Table &table, const std::string &file);

  /** Which of @p rows of @p table stand at one place, x_m and y_m, with
   * other numbers in one of @p columns: how many, and the first two by their
   * lines in the file. Empty where there are none. */
  std::string rows_that_disagree(const Table                    &table,
                                 const std::vector<std::size_t> &rows,
                                 const std::vector<std::string> &columns);
} // namespace squeal::tribology

#endif
