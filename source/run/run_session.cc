// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/blas_kernels.h>
#include <squeal/base/exceptions.h>
#include <squeal/base/root_action.h>
#include <squeal/base/version.h>
#include <squeal/parameters/declarations.h>
#include <squeal/parameters/text.h>
#include <squeal/results/result_checks.h>
#include <squeal/run/run_session.h>

#include <filesystem>
#include <sstream>

namespace squeal
{
  namespace
  {
    /** The parameter files and all that entries for files name. */
    NamedInputs
    inputs_of(const RunDescription &d, const prm::Schema &generic)
    {
      NamedInputs inputs;
      if (std::filesystem::exists(d.parameter_file)) // not of a made-up run
        for (const std::string &file : prm::prm_files_of(d.parameter_file))
          inputs.emplace_back("the run", file);
      for (const auto &[path, value] : d.used)
        if (const auto *entry = generic.find(prm::generic_path(path));
            entry && entry->allowed.kind() == prm::Allowed::Kind::file)
          for (const std::string &file : prm::split(value, ','))
            inputs.emplace_back("the entry " + prm::in_quotes(path), file);
      return inputs;
    }

    /** What stops the root stops all ranks, which wait for its word in the
     * constructor below. */
    OutputDirectory
    directory_of(const RunDescription &d,
                 const prm::Schema    &generic,
                 const bool            is_root)
    {
      try
        {
          if (is_root)
            refuse_to_remove_inputs(d.directory, inputs_of(d, generic));
          return OutputDirectory(d.directory, d.overwrite, is_root);
        }
      catch (const InputError &e)
        {
          from_root(e.what());
          throw;
        }
    }
  } // namespace



  RunSession::RunSession(const RunDescription &d,
                         const prm::Schema    &generic,
                         const bool            root)
    : description(d)
    , is_root(root)
    , log(root, d.options.is_quiet)
    , output(directory_of(d, generic, root))
    , plotter(log,
              [this](const std::string &path) {
                output.file(std::filesystem::path(path)
                              .lexically_relative(output.path())
                              .string());
              })
    , interrupt_guard(d.directory, root)
    , void_checks(find_void_checks(d.result_checks, d.options.settings))
  {
    const std::string failure = from_root("");
    if (!failure.empty())
      throw InputError(failure);
    log.open(output.file(log_file_name));
    record.versions.emplace_back("squeal",
                                 std::string(version::program) + " (" +
                                   version::revision + ", " +
                                   version::build_type + ")");
    record.versions.emplace_back("compiler", version::compiler);
    for (const auto &[name, number] : version::libraries)
      record.versions.emplace_back(name, number);
    record.versions.emplace_back("OpenBLAS kernels", blas_kernels::in_use());
    record.analysis       = d.analysis;
    record.scene          = d.scene;
    record.parameter_file = d.parameter_file;
    record.settings       = d.options.settings;
    record.void_checks    = void_checks.names;
    record.void_cause     = void_checks.cause;
    record.parameters     = without_checks(d.used, void_checks.names);
    record.n_ranks        = d.n_ranks;

    log.heading("squeal " + std::string(version::program) + ": " + d.analysis +
                (d.scene.empty() ? "" : " of scene " + d.scene));
    log.info("kernels of OpenBLAS: " + blas_kernels::in_use());
    std::ostringstream text;
    prm::print_used(record.parameters, generic, text);
    log.info("\nentries that differ from their defaults (all of them: " +
             output.path() + "/parameters_used.prm)\n" + text.str());
    for (const auto &note : d.notes)
      log.warning(note);
    if (!output.is_owned())
      log.warning("the file system of '" + output.path() +
                  "' has no locks: do not start a second run in it");
    if (root)
      prm::write_used(
        record.parameters, generic, output.file("parameters_used.prm"));
  }



  RunSession::~RunSession()
  {
    if (!is_finished)
      output.discard();
  }



  void
  RunSession::write_table(const std::string &name, const Table &table)
  {
    tables[name] = std::make_unique<Table>(table);
    if (is_root)
      table.write_csv(output.file(name));
  }



  std::string
  RunSession::commands() const
  {
    namespace fs             = std::filesystem;
    const fs::path directory = fs::absolute(output.path()).lexically_normal();
    return "# in the folder " + fs::current_path().string() + "\n" +
           command_of_run(description.parameter_file,
                          description.options.settings,
                          description.n_ranks) +
           "\n\n# by the entries as used, from any folder\n" +
           command_of_run((directory / "parameters_used.prm").string(),
                          {"Output directory = " + output.path() + "_again"},
                          description.n_ranks);
  }



  void
  RunSession::finish(HtmlReport *report, const std::string &open_this)
  {
    std::map<std::string, const Table *> views;
    for (const auto &[name, table] : tables)
      views[name] = table.get();
    record.checks = evaluate_result_checks(
      without_checks(description.result_checks, void_checks.names), views);
    record.take_timings(timers);
    record.warnings = log.warnings();
    if (is_root)
      {
        if (report)
          output.file("report.html");
        output.file(record_file_name);
        record.files.assign(output.files().begin(), output.files().end());
        write_run_record(record, output.file(record_file_name));
        if (report)
          {
            report->run_record(record, commands());
            report->link_tables(views);
            report->write(output.file("report.html"));
          }
      }
    output.require_in_place();
    is_finished = true;
    RunLog::Lines figures(record.figures.begin(), record.figures.end());
    log.summary(figures, timers);
    print_result_checks(record.checks, log);
    if (!void_checks.names.empty())
      log.result((record.checks.empty() ? "\nresult checks: " : "  ") +
                 void_checks.text());
    log.result("results: " + output.path() +
               (report ? ", read " + output.path() + "/report.html" : ""));
    if (!open_this.empty())
      log.result("open this in ParaView: " + output.path() + "/" + open_this);
    require_passed(record.checks);
  }
} // namespace squeal
