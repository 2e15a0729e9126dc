// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_analyses_triggers_trigger_tables_h
#define squeal_analyses_triggers_trigger_tables_h

#include <squeal/analyses/triggers/trigger_search.h>
#include <squeal/results/table.h>

#include <string>
#include <vector>

namespace squeal
{
  /** One row for each point. */
  Table trigger_table(const std::vector<TriggerResult> &results);

  /** Every impulse that was tried, in order. */
  Table trial_table(const std::vector<TriggerResult> &results);

  /** Window by window: the motions below and above the threshold, that after
   * the largest impulse and those on the edge. */
  Table motion_table(const std::vector<TriggerResult> &results);

  /** The numbers of a kept row of trigger_table(), in words. */
  std::string trigger_sentence(const Table &table, const std::size_t row);
} // namespace squeal

#endif
