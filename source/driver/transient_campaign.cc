// SPDX-License-Identifier: LGPL-2.1-or-later

// Transients over the axes of `Sweep` and several tops, several at a time.

#include <squeal/base/exceptions.h>
#include <squeal/base/stop_request.h>
#include <squeal/driver/campaign_table.h>
#include <squeal/driver/run_context.h>
#include <squeal/driver/transient_results.h>
#include <squeal/parameters/choices.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <future>
#include <sstream>

namespace squeal
{
  namespace
  {
    using Kind = SupportParameters::Kind;

    /** What the key of a run's phases ends with. */
    const std::string phase_key = "phases";

    std::vector<double>
    axis_values(const SweepAxisParameters &a)
    {
      if (a.scale == SweepAxisParameters::Scale::list)
        return a.values;
      std::vector<double> result;
      for (unsigned int i = 0; i < a.number; ++i)
        {
          const double s = a.number > 1 ? double(i) / (a.number - 1) : 0.;
          result.push_back(a.scale == SweepAxisParameters::Scale::logarithmic
                             ? a.from[0] * std::pow(a.to[0] / a.from[0], s)
                             : (1. - s) * a.from[0] + s * a.to[0]);
        }
      return result;
    }

    bool
    is_friction(const SweepAxisParameters &a)
    {
      for (const auto &entry : a.entries)
        if (entry.find("/Friction coefficient") == std::string::npos)
          return false;
      return true;
    }

    /** What a table shows of a value: names tell. */
    double
    shown_value(const std::string &axis, const double value)
    {
      if (axis.rfind("log10_", 0) == 0)
        return std::log10(value);
      return axis.size() > 4 && axis.substr(axis.size() - 4) == "_mpa"
               ? 1e-6 * value
               : value;
    }

    /** Combinations of the values of some axes. */
    std::vector<std::vector<double>>
    combinations(const std::vector<SweepAxisParameters> &axes,
                 const bool                              friction)
    {
      std::vector<std::vector<double>> all = {{}};
      for (const auto &axis : axes)
        if (is_friction(axis) == friction)
          {
            std::vector<std::vector<double>> next;
            for (const auto &head : all)
              for (const double value : axis_values(axis))
                {
                  next.push_back(head);
                  next.back().push_back(value);
                }
            all = next;
          }
      return all;
    }

    Parameters
    at_point(Parameters                              p,
             const std::vector<SweepAxisParameters> &axes,
             const std::vector<double>              &values,
             const bool                              friction)
    {
      std::size_t i = 0;
      for (const auto &axis : axes)
        if (is_friction(axis) == friction)
          {
            for (const auto &entry : axis.entries)
              p = with_value(p, entry, values[i]);
            ++i;
          }
      return p;
    }



    /** All runs with one set of bodies. */
    class CampaignGroup
    {
    public:
      CampaignGroup(const Parameters &p, RunContext &c)
        : parameters(p)
        , context(c)
        , model(parameters, c.timers)
        , pressed(parameters,
                  *model.discretization(),
                  model.body_matrices(),
                  parameters.transient.cut_off,
                  c.timers,
                  parameters.transient.interface_cut_off)
      {
        context.record.n_dofs = model.n_unknowns();
      }

      struct Outcome
      {
        std::vector<Cell> row;
        Table             phases;
      };

      /** Steady sliding and its linearisation; null where there is none. */
      std::unique_ptr<PreparedTransient>
      prepare(const CampaignRun &run)
      {
        PressedModel with = pressed;
        with.set_friction(
          std::abs(run.parameters.scene.contacts[0].friction_coefficient));
        try
          {
            return std::make_unique<PreparedTransient>(
              with, run.parameters, context.timers);
          }
        catch (const ComputationError &e)
          {
            context.log.warning(e.what());
            return {};
          }
      }

      /** For a thread of its own. With a comparison the run ends with its
       * linear phase. */
      static TransientRecord
      integrate(const CampaignRun       &run,
                const PreparedTransient &prepared,
                const StopRequest       &stop)
      {
        TransientRun transient(prepared.pressed,
                               prepared.steady,
                               prepared.linear,
                               prepared.branches,
                               run.parameters);
        const bool   linear_only = run.parameters.transient.compare_with_cea;
        transient.advance([&](const unsigned int) {
          return stop.is_there() ||
                 (linear_only && !transient.record().changes.empty());
        });
        return transient.record();
      }

      Outcome
      evaluate(const CampaignRun       &run,
               const PreparedTransient &prepared,
               const TransientRecord   &record)
      {
        ComplexPairs cea;
        if (run.parameters.transient.compare_with_cea)
          cea = whole_model_pairs(run.parameters,
                                  prepared.pressed.state_of(prepared.steady),
                                  context.log,
                                  context.timers);
        const TransientFigures f = evaluate_transient(
          prepared, record, run.parameters, cea.size() > 0 ? &cea : nullptr);
        return {campaign_row(run, prepared, record, f), phase_table(record, f)};
      }

    private:
      const Parameters parameters;
      RunContext      &context;
      Model            model;
      PressedModel     pressed;
    };



    std::string
    finished_file(const Parameters &p)
    {
      std::string directory = p.output.directory;
      while (directory.size() > 1 && directory.back() == '/')
        directory.pop_back();
      return directory + "_runs.json";
    }

    std::vector<double>
    shown_values(const std::vector<SweepAxisParameters> &axes,
                 const std::vector<double>              &others,
                 const std::vector<double>              &frictions)
    {
      std::vector<double> result;
      std::size_t         i = 0, k = 0;
      for (const auto &axis : axes)
        result.push_back(shown_value(
          axis.name, is_friction(axis) ? frictions[k++] : others[i++]));
      return result;
    }

    /** Runs side by side: factorisations of full models stand one at a time. */
    unsigned int
    n_threads(const std::vector<CampaignRun> &runs, const unsigned int asked)
    {
      for (const auto &run : runs)
        if (run.parameters.transient.integrator !=
            TransientParameters::Integrator::reduced)
          return 1;
      return asked;
    }

    /** The same run by each integrator asked for. */
    std::vector<CampaignRun>
    by_integrators(const CampaignRun &run)
    {
      const auto &asked = run.parameters.transient.integrators;
      if (asked.empty())
        return {run};
      std::vector<CampaignRun> result;
      for (const auto &[name, integrator] :
           choices(TransientParameters::Integrator()))
        if (std::find(asked.begin(), asked.end(), name) != asked.end())
          {
            result.push_back(run);
            result.back().parameters.transient.integrator = integrator;
          }
      return result;
    }

    /** What a campaign gathers. */
    struct CampaignResults
    {
      explicit CampaignResults(const Parameters &p)
        : table(campaign_columns(p))
        , keeps_phases(has_trigger(p.transient) &&
                       !p.transient.compare_with_cea)
      {
      }

      Table table;
      /** Phases over time are kept where a trigger is there. */
      bool                                       keeps_phases;
      std::vector<std::pair<std::string, Table>> phases;
    };

    /** The values of a run's axes, "mu 0.35". */
    std::string
    run_label(const CampaignRun &run, const Table &table)
    {
      std::string label;
      for (std::size_t i = 0; i < run.shown.size(); ++i)
        label += (label.empty() ? "" : ", ") + table.columns()[i].name + " " +
                 rounded_text(run.shown[i], 4);
      return label + (label.empty() ? "" : " ") + run.top;
    }

    /** All rows of a table of numbers one after the other, and back. */
    std::vector<Cell>
    joined(const Table &table)
    {
      std::vector<Cell> all;
      for (std::size_t i = 0; i < table.n_rows(); ++i)
        for (std::size_t c = 0; c < table.columns().size(); ++c)
          all.push_back(table.cell(i, c));
      return all;
    }

    Table
    phases_of(const std::vector<Cell> &all)
    {
      Table             table = phase_table(TransientRecord(), {});
      const std::size_t n     = table.columns().size();
      for (std::size_t i = 0; i + n <= all.size(); i += n)
        table.add_row({all.begin() + i, all.begin() + i + n});
      return table;
    }

    /** The phases of all runs as one table with the axes in front. */
    Table
    all_phases(const CampaignResults          &results,
               const std::vector<CampaignRun> &runs)
    {
      Table table;
      for (std::size_t k = 0; k < results.phases.size(); ++k)
        {
          Table part = results.phases[k].second;
          for (std::size_t i = runs[k].shown.size(); i-- > 0;)
            part.put_first(results.table.columns()[i], runs[k].shown[i]);
          table.append(part);
        }
      return table;
    }

    /** Runs of one group that are still to be done, a few at a time. */
    void
    run_group(const std::vector<CampaignRun> &runs,
              RunContext                     &context,
              FinishedRuns                   &finished,
              Progress                       &progress,
              CampaignResults                &results)
    {
      Table             &table = results.table;
      const unsigned int side_by_side =
        n_threads(runs, context.parameters.transient.threads);
      std::unique_ptr<CampaignGroup> group;
      const auto                     add = [&](const CampaignRun       &run,
                           const std::vector<Cell> &row,
                           const std::vector<Cell> &phases,
                           const bool               is_new) {
        table.add_row(row);
        if (results.keeps_phases)
          results.phases.emplace_back(run_label(run, table), phases_of(phases));
        if (is_new && context.is_root)
          {
            if (results.keeps_phases)
              finished.add(run.key + phase_key, phases);
            finished.add(run.key, row);
          }
        progress.advance(1, run.top);
      };
      for (std::size_t first = 0; first < runs.size(); first += side_by_side)
        {
          const std::size_t last =
            std::min<std::size_t>(first + side_by_side, runs.size());
          std::vector<std::unique_ptr<PreparedTransient>> prepared;
          std::vector<std::future<TransientRecord>>       records;
          std::vector<std::vector<Cell>>                  rows(last - first);
          StopRequest                                     stop;
          for (std::size_t i = first; i < last; ++i)
            {
              prepared.emplace_back();
              records.emplace_back();
              if (finished.find(
                    runs[i].key, table.columns().size(), rows[i - first]))
                continue;
              if (!group)
                group = std::make_unique<CampaignGroup>(runs[first].parameters,
                                                        context);
              prepared.back() = group->prepare(runs[i]);
              if (prepared.back())
                records.back() =
                  std::async(std::launch::async, [&, i, first]() {
                    return CampaignGroup::integrate(
                      runs[i], *prepared[i - first], stop);
                  });
            }
          for (std::size_t i = first; i < last; ++i)
            {
              const bool is_known = !rows[i - first].empty();
              if (is_known)
                {
                  std::vector<Cell> phases;
                  finished.find(runs[i].key + phase_key, 0, phases);
                  add(runs[i], rows[i - first], phases, false);
                  continue;
                }
              if (!prepared[i - first])
                {
                  add(runs[i], row_without_sliding(runs[i], table), {}, true);
                  continue;
                }
              TransientRecord record;
              {
                Timers::Section section(context.timers, "Solve: time steps");
                record = records[i - first].get();
              }
              if (stop.is_there())
                {
                  for (std::size_t k = i + 1; k < last; ++k)
                    if (records[k - first].valid())
                      records[k - first].wait();
                  context.log.info("stopped; the same command goes on with the "
                                   "runs that are left");
                  stop.repeat();
                }
              const auto outcome =
                group->evaluate(runs[i], *prepared[i - first], record);
              add(runs[i], outcome.row, joined(outcome.phases), true);
            }
        }
    }
  } // namespace



  void
  run_campaign(RunContext &context)
  {
    const Parameters        &p    = context.parameters;
    const auto              &axes = p.sweep.axes;
    std::vector<std::string> tops = p.transient.tops;
    if (tops.empty())
      tops.push_back("");
    CampaignResults                       results(p);
    std::vector<std::vector<CampaignRun>> groups;
    std::size_t                           n_runs = 0;
    for (const std::string &top : tops)
      for (const auto &others : combinations(axes, false))
        {
          Parameters base = at_point(p, axes, others, false);
          groups.emplace_back();
          for (const auto &frictions : combinations(axes, true))
            {
              CampaignRun run{at_point(base, axes, frictions, true),
                              shown_values(axes, others, frictions),
                              top,
                              ""};
              auto       &scene       = run.parameters.scene;
              scene.contacts[0].state = ContactParameters::State::full;
              for (auto &support : scene.supports)
                if (!top.empty() && support.name == p.transient.top_support)
                  for (const auto &[name, kind] : choices(Kind()))
                    if (name == top)
                      support.kind = kind;
              // Node fields and frames are not kept in a campaign.
              run.parameters.transient.history_start       = 1e300;
              run.parameters.transient.animation_frames    = 0;
              run.parameters.discretization.estimate_error = false;
              for (CampaignRun &each : by_integrators(run))
                {
                  each.key = key_of_motion(each.parameters);
                  // Axes may be numbers that the key does not name.
                  for (std::size_t i = 0; i < axes.size(); ++i)
                    each.key +=
                      axes[i].name + " " + shortest_text(each.shown[i]) + "\n";
                  groups.back().push_back(each);
                  ++n_runs;
                }
            }
        }
    if (p.scene.contacts[0].friction_coefficient < 0.)
      throw InputError("Scene/Contact/Friction coefficient: a campaign needs "
                       "one of at least 0");
    FinishedRuns finished(finished_file(p), p.transient.resume);
    {
      Progress progress(context.log, "transients", n_runs);
      for (const auto &runs : groups)
        run_group(runs, context, finished, progress, results);
    }
    const Table &table = results.table;
    context.write_table(p.transient.campaign_table, table);
    std::ostringstream text;
    table.print(text);
    context.log.heading("Campaign");
    context.log.info(text.str());
    context.record.figures = {{"runs", std::to_string(table.n_rows())}};
    HtmlReport report("Transients of " + p.scene.name,
                      "over the axes of the campaign");
    report.set_verdict(HtmlReport::Verdict::neutral,
                       std::to_string(table.n_rows()) + " runs",
                       context.record.figures);
    if (results.keeps_phases)
      {
        std::vector<CampaignRun> runs;
        for (const auto &group : groups)
          runs.insert(runs.end(), group.begin(), group.end());
        context.write_table("phases.csv", all_phases(results, runs));
      }
    if (p.output.plots && context.is_root)
      {
        draw_campaign(context, table, report);
        if (results.keeps_phases)
          draw_phases(context, results.phases, report);
      }
    report.section("Runs");
    report.table(table, "One row for each run");
    context.finish(p.output.report ? &report : nullptr, "");
  }
} // namespace squeal
