// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_analyses_triggers_trigger_charts_h
#define squeal_analyses_triggers_trigger_charts_h

#include <squeal/results/table.h>

namespace squeal
{
  class RunContext;
  class HtmlReport;

  /** Forces over time either side of the threshold and on the edge, a panel for
   * each point; of the first scene of a campaign. @p motions: as
   * motion_table(), of one scene. */
  void draw_motions(RunContext  &context,
                    const Table &motions,
                    HtmlReport  &report);

  /** The two cycles and the threshold over the first axis of a campaign. @p
   * triggers: as trigger_table(), with the axes in front. */
  void draw_branches(RunContext  &context,
                     const Table &triggers,
                     HtmlReport  &report);
} // namespace squeal

#endif
