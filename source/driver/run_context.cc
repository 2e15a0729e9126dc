// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/version.h>
#include <squeal/driver/run_context.h>
#include <squeal/results/result_checks.h>

#include <mpi.h>

#include <sstream>

namespace squeal
{
  namespace
  {
    std::string
    analysis_name(const Parameters::Analysis analysis)
    {
      switch (analysis)
        {
        case Parameters::Analysis::modes:
          return "modes";
        case Parameters::Analysis::cea:
          return "cea";
        case Parameters::Analysis::sweep:
          return "sweep";
        case Parameters::Analysis::work_precision:
          return "work precision";
        }
      return "";
    }
  } // namespace



  RunContext::RunContext(const Parameters &p, const bool root)
    : parameters(p)
    , is_root(root)
    , log(root)
    , output(p.output.directory, p.output.overwrite, root)
    , plotter(log)
    , interrupt_guard(p.output.directory, root)
  {
    int n_ranks;
    MPI_Comm_size(MPI_COMM_WORLD, &n_ranks);
    log.open(output.file(log_file_name));
    record.versions.emplace_back("squeal",
                                 std::string(version::program) + " (" +
                                   version::revision + ", " +
                                   version::build_type + ")");
    record.versions.emplace_back("compiler", version::compiler);
    for (const auto &[name, number] : version::libraries)
      record.versions.emplace_back(name, number);
    record.analysis       = analysis_name(p.analysis);
    record.scene          = p.scene.name;
    record.parameter_file = p.file;
    record.parameters     = p.used;
    record.n_ranks        = n_ranks;

    log.heading("squeal " + std::string(version::program) + ": " +
                record.analysis + " of scene " + p.scene.name);
    std::ostringstream text;
    print_parameters(p, text);
    log.info(text.str());
    for (const auto &note : p.notes)
      log.warning(note);
    if (root)
      write_used_parameters(p, output.file("parameters_used.prm"));
  }



  RunContext::~RunContext()
  {
    if (!is_finished)
      output.discard();
  }



  void
  RunContext::write_table(const std::string &name, const Table &table)
  {
    tables[name] = std::make_unique<Table>(table);
    if (is_root)
      table.write_csv(output.file(name));
  }



  void
  RunContext::finish(HtmlReport *report, const std::string &open_this)
  {
    std::map<std::string, const Table *> views;
    for (const auto &[name, table] : tables)
      views[name] = table.get();
    record.checks = evaluate_result_checks(parameters.result_checks, views);
    record.take_timings(timers);
    record.warnings = log.warnings();
    if (is_root)
      {
        if (report)
          output.file("report.html");
        output.file("run.json");
        record.files.assign(output.files().begin(), output.files().end());
        write_run_record(record, output.file("run.json"));
        if (report)
          {
            report->run_record(record, "./squeal run " + parameters.file);
            report->write(output.file("report.html"));
          }
      }
    is_finished = true;
    RunLog::Lines figures(record.figures.begin(), record.figures.end());
    log.summary(figures, timers);
    print_result_checks(record.checks, log);
    log.info("results: " + output.path() +
             (report ? ", read " + output.path() + "/report.html" : ""));
    if (!open_this.empty())
      log.info("open this in ParaView: " + output.path() + "/" + open_this);
    require_passed(record.checks);
  }
} // namespace squeal
