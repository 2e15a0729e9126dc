// SPDX-License-Identifier: LGPL-2.1-or-later

// Transients over the axes of `Sweep` and several tops, several at a time.

#include <squeal/analyses/transient/campaign_table.h>
#include <squeal/analyses/transient/transient_results.h>
#include <squeal/analyses/transient/transient_verdict.h>
#include <squeal/base/exceptions.h>
#include <squeal/base/stop_request.h>
#include <squeal/model/drive_warnings.h>
#include <squeal/model/pressed_scene.h>
#include <squeal/output/headlines.h>
#include <squeal/output/record_unknowns.h>
#include <squeal/parameters/choices.h>
#include <squeal/parameters/entry_traits.h>
#include <squeal/results/column_title.h>
#include <squeal/run/campaign_file.h>
#include <squeal/run/campaign_runs.h>
#include <squeal/run/run_context.h>

#include <algorithm>
#include <cmath>
#include <future>
#include <memory>
#include <sstream>

namespace squeal
{
  namespace
  {
    /** Names of the rows that a finished run keeps. */
    const std::string row_name = "row", phase_name = "phases";

    /** All runs with one set of bodies. */
    class CampaignGroup
    {
    public:
      CampaignGroup(const Parameters &p, RunContext &c)
        : context(c)
        , scene(p, c.timers)
      {
        record_unknowns(scene.model, context.record);
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
        try
          {
            return std::make_unique<PreparedTransient>(
              scene.pressed.with_friction(
                friction_sizes(run.parameters.scene.contacts)),
              run.parameters,
              context.timers);
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
      integrate(const CampaignRun &run,
                TransientRun      &transient,
                const StopRequest &stop)
      {
        const bool linear_only = run.parameters.transient.compare_with_cea;
        transient.advance([&](const unsigned int) {
          return stop.is_there() ||
                 (linear_only && transient.record().n_changes > 0.);
        });
        return transient.record();
      }

      /** @p label: of the run, for warnings. */
      Outcome
      evaluate(const CampaignRun       &run,
               const std::string       &label,
               const PreparedTransient &prepared,
               const TransientRecord   &record)
      {
        ComplexPairs cea;
        if (run.parameters.transient.compare_with_cea)
          cea = whole_model_pairs(run.parameters,
                                  prepared.pressed.states_of(prepared.steady),
                                  context.log,
                                  context.timers);
        const TransientFigures f = evaluate_transient(
          prepared, record, run.parameters, cea.size() > 0 ? &cea : nullptr);
        const std::string place = label.empty() ? "" : label + ": ";
        if (const std::string text = text_of_moment(f); !text.empty())
          context.log.warning(place + text);
        if (f.beyond_samples > 0.)
          context.log.warning(
            place + text_of_sampling(f.beyond_samples,
                                     run.parameters.transient.sample_interval,
                                     f.is_beyond_in_steps));
        return {campaign_row(run, prepared, record, f), phase_table(record, f)};
      }

    private:
      RunContext        &context;
      const PressedScene scene;
    };



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

    /** The values of a run's axes, its top and, of several, its integrator:
     * "mu 0.35, guided". */
    std::string
    run_label(const CampaignRun &run, const Table &table)
    {
      std::string label;
      for (std::size_t i = 0; i < run.shown.size(); ++i)
        label += (label.empty() ? "" : ", ") +
                 ColumnTitle(table.columns()[i]).with(run.shown[i]);
      const auto &t = run.parameters.transient;
      for (const std::string &part :
           {run.top, t.integrators.empty() ? "" : choice_name(t.integrator)})
        label += (label.empty() || part.empty() ? "" : ", ") + part;
      return label;
    }

    Table
    phases_of(const std::vector<Cell> &all)
    {
      Table table = phase_table(TransientRecord(), {});
      add_rows(table, all);
      return table;
    }

    /** The phases of all runs as one table, in front what tells runs apart. */
    Table
    all_phases(const CampaignResults          &results,
               const std::vector<CampaignRun> &runs)
    {
      Table table;
      for (std::size_t k = 0; k < results.phases.size(); ++k)
        {
          Table part = results.phases[k].second;
          part.put_first({"integrator", Table::Type::text, "", ""},
                         choice_name(runs[k].parameters.transient.integrator));
          part.put_first({"top", Table::Type::text, "", "kind of the support"},
                         runs[k].top);
          for (std::size_t i = runs[k].shown.size(); i-- > 0;)
            part.put_first(results.table.columns()[i], runs[k].shown[i]);
          table.append(part);
        }
      return table;
    }

    /** A run of a group on its way. */
    struct StartedRun
    {
      std::vector<Cell>                  row; /**< if it was finished before */
      std::unique_ptr<PreparedTransient> prepared; /**< null: no sliding */
      std::unique_ptr<TransientRun>      transient;
      std::future<TransientRecord>       record;
    };



    /** Runs a campaign group by group and keeps what is finished. */
    class CampaignRunner
    {
    public:
      CampaignRunner(RunContext      &context,
                     FinishedRuns    &finished,
                     Progress        &progress,
                     CampaignResults &results)
        : context(context)
        , finished(finished)
        , progress(progress)
        , results(results)
      {
      }

      /** Runs of one group that are still to be done, a few at a time. */
      void
      run(const std::vector<CampaignRun> &runs)
      {
        std::unique_ptr<CampaignGroup> group;
        const std::size_t              side_by_side =
          n_threads(runs, context.parameters.transient.threads);
        for (std::size_t first = 0; first < runs.size(); first += side_by_side)
          {
            const std::size_t n = std::min(side_by_side, runs.size() - first);
            StopRequest       stop;
            // They stay where they are: threads read them.
            std::vector<StartedRun> started(n);
            for (std::size_t i = 0; i < n; ++i)
              start(runs[first + i], group, stop, started[i]);
            for (std::size_t i = 0; i < n; ++i)
              finish(runs[first + i], group, stop, i, started);
          }
      }

    private:
      RunContext         &context;
      FinishedRuns       &finished;
      Progress           &progress;
      CampaignResults    &results;
      const InputsAtStart inputs;

      void
      start(const CampaignRun              &run,
            std::unique_ptr<CampaignGroup> &group,
            const StopRequest              &stop,
            StartedRun                     &started)
      {
        if (finished.find(run.fingerprint,
                          row_name,
                          results.table.columns().size(),
                          started.row))
          return;
        if (!group)
          group = std::make_unique<CampaignGroup>(run.parameters, context);
        started.prepared = group->prepare(run);
        if (!started.prepared)
          return;
        warn_of_short_lag(started.prepared->pressed,
                          started.prepared->steady,
                          run.parameters,
                          context.log);
        // Not in the thread: a blow is a load that MUMPS solves for, and MUMPS
        // runs in one thread at a time.
        started.transient =
          std::make_unique<TransientRun>(started.prepared->pressed,
                                         started.prepared->steady,
                                         started.prepared->linear,
                                         started.prepared->branches,
                                         run.parameters);
        started.record = std::async(std::launch::async, [&]() {
          return CampaignGroup::integrate(run, *started.transient, stop);
        });
      }

      void
      finish(const CampaignRun              &run,
             std::unique_ptr<CampaignGroup> &group,
             StopRequest                    &stop,
             const std::size_t               i,
             std::vector<StartedRun>        &started)
      {
        if (!started[i].row.empty())
          {
            std::vector<Cell> phases;
            finished.find(run.fingerprint, phase_name, 0, phases);
            add(run, started[i].row, phases);
            return;
          }
        if (!started[i].prepared)
          {
            keep(run, row_without_sliding(run, results.table), {});
            return;
          }
        TransientRecord record;
        {
          Timers::Section section(context.timers, "Solve: time steps");
          record = started[i].record.get();
        }
        if (stop.is_there())
          {
            for (StartedRun &other : started)
              if (other.record.valid())
                other.record.wait();
            context.log.info("stopped; the same command goes on with the "
                             "runs that are left");
            stop.repeat();
          }
        const auto outcome = group->evaluate(
          run, run_label(run, results.table), *started[i].prepared, record);
        keep(run, outcome.row, all_cells(outcome.phases));
      }

      void
      add(const CampaignRun       &run,
          const std::vector<Cell> &row,
          const std::vector<Cell> &phases)
      {
        results.table.add_row(row);
        if (results.keeps_phases)
          results.phases.emplace_back(run_label(run, results.table),
                                      phases_of(phases));
        progress.advance(1, run.top);
      }

      /** A new row. */
      void
      keep(const CampaignRun       &run,
           const std::vector<Cell> &row,
           const std::vector<Cell> &phases)
      {
        inputs.require_same();
        add(run, row, phases);
        if (!context.is_root)
          return;
        // first what the row is not complete without
        if (results.keeps_phases)
          finished.add(run.fingerprint, phase_name, phases);
        finished.add(run.fingerprint, row_name, row);
      }
    };



    /** Warns of the limit cycles whose rms has not settled. */
    void
    warn_of_rising_rms(const Table                    &table,
                       const std::vector<CampaignRun> &runs,
                       RunLog                         &log)
    {
      if (!table.has_column("rms_normal_change_n"))
        return;
      std::string text;
      for (std::size_t k = 0; k < table.n_rows(); ++k)
        {
          const double change = table.real(k, "rms_normal_change_n"),
                       rms    = table.real(k, "rms_normal_n");
          // Pure stick-slip leaves but noise of the solver in the normal force.
          const bool vibrates = rms > least_vibration *
                                        table.real(k, "judged_share") *
                                        table.real(k, "max_normal_n");
          if (vibrates && table.text(k, "limit_cycle") == "yes" &&
              std::abs(change) > settled_rms_change * rms)
            text += (text.empty() ? "" : "; ") + run_label(runs[k], table) +
                    " (by " + rounded_text(100. * std::abs(change) / rms, 2) +
                    " %)";
        }
      if (!text.empty())
        log.warning(
          "the rms of these limit cycles still rises or falls between "
          "the halves of the time that it is taken over: " +
          text + ": raise 'Transient/End time'");
    }



    std::string
    campaign_verdict(const Table &table, const Parameters &p)
    {
      if (table.has_column("rate_difference"))
        return comparison_headline(table);
      if (table.has_column("outcome"))
        return trigger_headline(table, p.sweep, p.scene);
      const bool over_speed =
        !p.sweep.axes.empty() &&
        unit_of_entry(p.sweep.axes[0].entries.at(0), p.scene) == "m/s";
      const std::string friction =
        over_speed ? friction_headline(table, p.sweep, p.scene) : "";
      return (friction.empty() ? "" : friction + "; ") +
             campaign_headline(table);
    }



    void
    report_campaign(RunContext                     &context,
                    const CampaignResults          &results,
                    const std::vector<CampaignRun> &runs)
    {
      const Parameters &p     = context.parameters;
      const Table      &table = results.table;
      context.write_table(p.transient.campaign_table, table);
      std::ostringstream text;
      table.print(text);
      context.log.heading("Campaign");
      context.log.info(text.str());
      context.record.figures = {{"runs", std::to_string(table.n_rows())}};
      HtmlReport report("Transients of " + p.scene.name,
                        "over the axes of the campaign");
      report.set_verdict(HtmlReport::Verdict::neutral,
                         campaign_verdict(table, p),
                         context.record.figures);
      if (results.keeps_phases)
        context.write_table("phases.csv", all_phases(results, runs));
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
  } // namespace



  void
  run_campaign(RunContext &context)
  {
    const Parameters              &p      = context.parameters;
    const auto                     groups = campaign_groups(p);
    const std::vector<CampaignRun> runs   = all_runs(groups);
    CampaignResults                results(p);
    warn_of_drive(p, context.log);
    FinishedRuns finished =
      finished_runs(context, runs, row_name, results.table.columns().size());
    {
      Progress       progress(context.log, "transients", runs.size());
      CampaignRunner runner(context, finished, progress, results);
      for (const auto &group : groups)
        runner.run(group);
    }
    warn_of_rising_rms(results.table, runs, context.log);
    report_campaign(context, results, runs);
  }
} // namespace squeal
