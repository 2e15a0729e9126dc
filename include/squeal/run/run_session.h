// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_run_run_session_h
#define squeal_run_run_session_h

#include <squeal/base/interrupt.h>
#include <squeal/base/output_directory.h>
#include <squeal/base/run_log.h>
#include <squeal/base/timers.h>
#include <squeal/parameters/analysis_parameters.h>
#include <squeal/parameters/schema_text.h>
#include <squeal/results/html_report.h>
#include <squeal/results/plotter.h>
#include <squeal/results/run_record.h>
#include <squeal/results/table.h>
#include <squeal/run/settings.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace squeal
{
  /** What a run is, whichever program it belongs to. */
  struct RunDescription
  {
    std::string                        analysis; /**< as in the file */
    std::string                        scene;    /**< or what is looked at */
    std::string                        parameter_file;
    prm::UsedEntries                   used;
    std::vector<std::string>           notes; /**< said as warnings */
    std::vector<ResultCheckParameters> result_checks;
    std::string                        directory;
    bool                               overwrite = false;
    unsigned int                       n_ranks   = 1;
    RunOptions                         options   = {};
  };

  /**
   * What every run of every program has: log, timers, the output directory and
   * the tables it hands over. finish() writes the record of the run and
   * evaluates the result checks; a run that ends before it, by an error or a
   * signal, leaves nothing but its log.
   */
  class RunSession
  {
  public:
    /** @p generic is the schema of the program with one member of each
     * family. */
    RunSession(const RunDescription &description,
               const prm::Schema    &generic,
               bool                  is_root);
    ~RunSession();
    RunSession(const RunSession &)            = delete;
    RunSession &operator=(const RunSession &) = delete;

    const RunDescription description;
    const bool           is_root;
    RunLog               log;
    Timers               timers;
    OutputDirectory      output;
    Plotter              plotter;
    RunRecord            record;

    /** Writes @p table as a CSV and keeps it for the result checks. */
    void write_table(const std::string &name, const Table &table);

    /**
     * Ends the run: result checks, run.json, the report (if there is one), the
     * summary. @p open_this names the file to open in ParaView; empty: none.
     * Throws CheckError when a result check failed.
     */
    void finish(HtmlReport *report, const std::string &open_this);

  private:
    /** What repeats the run, as typed in a shell. */
    std::string commands() const;

    InterruptGuard                                interrupt_guard;
    bool                                          is_finished = false;
    const VoidChecks                              void_checks;
    std::map<std::string, std::unique_ptr<Table>> tables;
  };
} // namespace squeal

#endif
