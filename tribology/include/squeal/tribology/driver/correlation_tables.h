// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_driver_correlation_tables_h
#define squeal_tribology_driver_correlation_tables_h

#include <squeal/results/table.h>
#include <squeal/tribology/driver/context.h>
#include <squeal/tribology/statistics/pad_tables.h>

#include <nlohmann/json.hpp>

#include <vector>

namespace squeal::tribology
{
  /** correlation.csv: a row for each link. */
  Table link_table(const std::vector<PadLink> &links, bool is_synthetic);

  /** The columns of it that the report shows: the verdicts with and without
   * shared causes, and what they rest on. */
  const std::vector<std::string> &columns_of_report();

  /** The links of correlation.json. */
  nlohmann::ordered_json json_of(const std::vector<PadLink> &links,
                                 bool                        is_synthetic);

  /** The groups of correlation.json. */
  nlohmann::ordered_json json_of(const std::vector<GroupResult> &groups,
                                 bool                            is_synthetic);

  /** self_test.csv: runs the self test. */
  Table self_test_table(Context &context);
} // namespace squeal::tribology

#endif
