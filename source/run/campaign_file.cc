// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/files.h>
#include <squeal/base/inputs_read.h>
#include <squeal/base/root_action.h>
#include <squeal/base/state_files.h>
#include <squeal/run/campaign_file.h>
#include <squeal/run/run_context.h>

#include <filesystem>

namespace squeal
{
  namespace
  {
    std::string
    path_of_file(RunContext &context)
    {
      const std::string file = context.output.state_file(
        "runs.json", state_kind::rows, "Output directory");
      if (context.is_root && !context.parameters.transient.resume &&
          std::filesystem::exists(file))
        context.log.warning("the runs in " + file +
                            " are not used, as Transient/Resume is false; kept "
                            "as '" +
                            set_aside(file) + "'");
      return file;
    }

    void
    log_found(const FinishedRuns             &finished,
              const std::vector<CampaignRun> &runs,
              const std::string              &name,
              const std::size_t               n_columns,
              const std::string              &file,
              RunLog                         &log)
    {
      std::vector<Cell>  row;
      const CampaignRun *missing = nullptr;
      unsigned int       n_found = 0;
      for (const CampaignRun &run : runs)
        if (finished.find(run.fingerprint, name, n_columns, row))
          ++n_found;
        else if (!missing)
          missing = &run;
      if (n_found > 0)
        log.info("  " + std::to_string(n_found) + " of " +
                 std::to_string(runs.size()) + " runs are taken from " + file);
      else if (missing && finished.n_rows() > 0)
        log.warning("the runs in " + file +
                    " are others and are kept there: of the one most alike, " +
                    finished.nearest_difference(missing->fingerprint));
    }
  } // namespace



  FinishedRuns
  finished_runs(RunContext                     &context,
                const std::vector<CampaignRun> &runs,
                const std::string              &name,
                const std::size_t               n_columns)
  {
    const std::string file =
      on_root(context.is_root, [&]() { return path_of_file(context); });
    FinishedRuns finished(file, on_root(context.is_root, [&]() {
                            return std::filesystem::exists(file)
                                     ? read_file(file)
                                     : "";
                          }));
    log_found(finished, runs, name, n_columns, file, context.log);
    return finished;
  }



  InputsAtStart::InputsAtStart()
    : inputs(inputs_read())
  {
  }

  void
  InputsAtStart::require_same() const
  {
    const auto now = inputs_read();
    for (const auto &[file, content] : inputs)
      if (now.at(file) != content)
        throw InputError("'" + file +
                         "' has changed since the campaign was started: "
                         "start it again");
  }



  std::vector<Cell>
  all_cells(const Table &table)
  {
    std::vector<Cell> all;
    for (std::size_t i = 0; i < table.n_rows(); ++i)
      for (std::size_t c = 0; c < table.columns().size(); ++c)
        all.push_back(table.cell(i, c));
    return all;
  }

  void
  add_rows(Table &table, const std::vector<Cell> &cells)
  {
    const std::size_t n = table.columns().size();
    for (std::size_t i = 0; i + n <= cells.size(); i += n)
      table.add_row({cells.begin() + i, cells.begin() + i + n});
  }



  void
  put_place(Table &table, const CampaignRun &run, const Parameters &p)
  {
    if (!run.top.empty())
      table.put_first({"top", Table::Type::text, "", "kind of the support"},
                      run.top);
    for (std::size_t i = run.shown.size(); i-- > 0;)
      table.put_first({p.sweep.axes[i].name,
                       Table::Type::real,
                       shown_unit(p.sweep.axes[i], p.scene),
                       "of the axis"},
                      run.shown[i]);
  }
} // namespace squeal
