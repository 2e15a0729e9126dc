// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_driver_run_context_h
#define squeal_driver_run_context_h

#include <squeal/base/files.h>
#include <squeal/base/interrupt.h>
#include <squeal/base/run_log.h>
#include <squeal/base/timers.h>
#include <squeal/parameters/parameters.h>
#include <squeal/results/html_report.h>
#include <squeal/results/plotter.h>
#include <squeal/results/run_record.h>
#include <squeal/results/table.h>

#include <map>
#include <memory>
#include <string>

namespace squeal
{
  /**
   * What every analysis shares: parameters, log, timers, the output directory
   * and the tables it hands over. finish() writes the record of the run and
   * evaluates the result checks; a run that ends before it, by an error or a
   * signal, leaves nothing but its log.
   */
  class RunContext
  {
  public:
    RunContext(const Parameters &parameters, const bool is_root);
    ~RunContext();

    const Parameters &parameters;
    const bool        is_root;
    RunLog            log;
    Timers            timers;
    OutputDirectory   output;
    Plotter           plotter;
    RunRecord         record;

    /** Writes @p table as a CSV and keeps it for the result checks. */
    void write_table(const std::string &name, const Table &table);

    /**
     * Ends the run: result checks, run.json, the report (if there is one), the
     * summary. @p open_this names the file to open in ParaView; empty: none.
     * Throws CheckError when a result check failed.
     */
    void finish(HtmlReport *report, const std::string &open_this);

  private:
    InterruptGuard                                interrupt_guard;
    bool                                          is_finished = false;
    std::map<std::string, std::unique_ptr<Table>> tables;
  };
} // namespace squeal

#endif
