// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_run_campaign_file_h
#define squeal_run_campaign_file_h

#include <squeal/run/campaign_runs.h>
#include <squeal/run/finished_runs.h>

#include <map>
#include <string>
#include <vector>

namespace squeal
{
  class RunContext;

  /** What earlier calls of the same command have finished, from `runs.json` of
   * the output directory, with a line in the log that says of how many of
   * @p runs it has the row @p name of @p n_columns numbers (0: of any number).
   * Without `Transient/Resume` an earlier file is put aside. */
  FinishedRuns finished_runs(RunContext                     &context,
                             const std::vector<CampaignRun> &runs,
                             const std::string              &name,
                             const std::size_t               n_columns);

  /** The files that the runs of a campaign read, as they were when it began:
   * a run that reads others than it is known by is not kept. */
  class InputsAtStart
  {
  public:
    InputsAtStart();

    /** Throws InputError where one has changed. */
    void require_same() const;

  private:
    const std::map<std::string, std::string> inputs;
  };

  /** Puts the values of the axes of @p p and the top of @p run in front of every
   * row. */
  void put_place(Table &table, const CampaignRun &run, const Parameters &p);

  /** All rows of a table one after the other, and back. */
  std::vector<Cell> all_cells(const Table &table);
  void              add_rows(Table &table, const std::vector<Cell> &cells);
} // namespace squeal

#endif
