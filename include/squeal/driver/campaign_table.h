// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_driver_campaign_table_h
#define squeal_driver_campaign_table_h

#include <squeal/driver/transient_results.h>
#include <squeal/parameters/parameters.h>

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace squeal
{
  /** One run of a campaign. */
  struct CampaignRun
  {
    Parameters          parameters;
    std::vector<double> shown; /**< values of the axes, as tables show them */
    std::string         top;   /**< kind of the support; empty as it stands */
    std::string         key;   /**< of everything that its motion depends on */
  };

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

  /** Rows of runs that an earlier campaign has finished, by their keys, in a
   * file that is rewritten after each run. */
  class FinishedRuns
  {
  public:
    /** Reads @p path if it is there and @p resume; throws InputError if it
     * cannot be read. */
    FinishedRuns(const std::string &path, const bool resume);

    /** False if there is no run @p key with @p n_columns numbers; 0: with any
     * number of them. */
    bool find(const std::string &key,
              const std::size_t  n_columns,
              std::vector<Cell> &row) const;
    void add(const std::string &key, const std::vector<Cell> &row);

  private:
    const std::string      path;
    nlohmann::ordered_json rows = nlohmann::ordered_json::object();
  };
} // namespace squeal

#endif
