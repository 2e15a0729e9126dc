// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_analyses_transient_campaign_table_h
#define squeal_analyses_transient_campaign_table_h

#include <squeal/analyses/transient/transient_results.h>
#include <squeal/run/campaign_runs.h>

#include <string>
#include <vector>

namespace squeal
{
  /** The table of a campaign without rows: growth beside the eigenvalues where
   * `Compare with CEA` asks for it, the limit cycle otherwise. */
  Table campaign_columns(const Parameters &parameters);

  std::vector<Cell> campaign_row(const CampaignRun       &run,
                                 const PreparedTransient &prepared,
                                 const TransientRecord   &record,
                                 const TransientFigures  &figures);

  /** The row of a point that has no steady sliding. */
  std::vector<Cell> row_without_sliding(const CampaignRun &run,
                                        const Table       &table);

  /** Draws growth in time against the eigenvalue analysis where they are
   * compared, and with two axes where each of them finds growth. */
  void draw_campaign(RunContext  &context,
                     const Table &table,
                     HtmlReport  &report);

  /** Draws the amplitude of the limit cycles over the growth rate and, with an
   * axis of it, vibration and macroscopic friction over the sliding speed;
   * where there are points enough. Not for a comparison with the CEA. */
  void draw_amplitudes(RunContext  &context,
                       const Table &table,
                       HtmlReport  &report);
} // namespace squeal

#endif
