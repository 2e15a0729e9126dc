// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/analyses/triggers/trigger_charts.h>
#include <squeal/analyses/triggers/trigger_search.h>
#include <squeal/analyses/triggers/trigger_tables.h>

#include <squeal/analyses/analyses.h>
#include <squeal/base/exceptions.h>
#include <squeal/base/stop_request.h>
#include <squeal/model/drive_warnings.h>
#include <squeal/model/growth_outside.h>
#include <squeal/model/measured_points.h>
#include <squeal/model/pressed_scene.h>
#include <squeal/model/rotor_symmetry.h>
#include <squeal/output/record_unknowns.h>
#include <squeal/parameters/entry_traits.h>
#include <squeal/results/html_report.h>
#include <squeal/run/campaign_file.h>
#include <squeal/run/run_context.h>

#include <algorithm>
#include <memory>
#include <sstream>

namespace squeal
{
  namespace
  {
    /** Names of what a finished scene keeps. */
    const std::string trigger_record = "triggers", trial_record = "trials",
                      motion_record = "trigger motions";

    struct TriggerTables
    {
      Table triggers = trigger_table({}), trials = trial_table({}),
            motions = motion_table({});
    };

    TriggerTables
    tables_of(const std::vector<TriggerResult> &results)
    {
      return {
        trigger_table(results), trial_table(results), motion_table(results)};
    }

    /** Places in `Measurement/Points` of those that are struck. */
    std::vector<unsigned int>
    struck_points(const Parameters &p)
    {
      std::vector<unsigned int> result;
      for (unsigned int i = 0; i < p.measurement.points.size(); ++i)
        if (const auto &points = p.triggers.points;
            points.empty() ||
            std::find(points.begin(),
                      points.end(),
                      p.measurement.points[i].name) != points.end())
          result.push_back(i);
      return result;
    }

    /** A moment of the normal forces that some motion of @p r is judged by;
     * empty where there is none. */
    std::string
    moment_in(const TriggerResult &r)
    {
      for (const std::string &moment :
           {r.strongest.windows.empty()
              ? std::string()
              : r.strongest.windows.back().judged_force,
            r.stable.figures.judged_force,
            r.edge.judged_force,
            r.unstable.figures.judged_force})
        if (!moment.empty())
          return moment;
      return "";
    }

    /** All points of scenes with one set of bodies. */
    class StruckScene
    {
    public:
      StruckScene(const Parameters &p, RunContext &c)
        : context(c)
        , scene(p, c.timers)
        , places(struck_points(p))
        , forces(
            scene.pressed.forces(MeasuredPoints(scene.model).vectors(places)))
      {
        record_unknowns(scene.model, context.record);
        warn_of_frozen_rotors(scene.model, context.log);
      }

      std::vector<TriggerResult>
      results(const CampaignRun &run)
      {
        const Parameters          &p = run.parameters;
        std::vector<TriggerResult> result;
        const auto                 about =
          scene.find_steady(p.scene.contacts, context.log, context.timers);
        LinearizedMotion linear;
        if (about)
          linear = linear_motion(*about, p);
        for (std::size_t i = 0; i < places.size(); ++i)
          {
            const std::string &name = p.measurement.points[places[i]].name;
            result.push_back(about ? result_at(*about, linear, name, i, p)
                                   : without(name, "no steady sliding"));
          }
        return result;
      }

    private:
      /** Says what grows outside the band, and what the damping at the cut-off
       * does to the pair of the band that is nearest to growth. */
      LinearizedMotion
      linear_motion(const SteadyModel &about, const Parameters &p)
      {
        LinearizedMotion linear = motions_about(about);
        if (const std::string text = text_of_growth_outside(
              growth_outside(about, linear, p, context.timers));
            !text.empty())
          context.log.warning(text + ": nothing is struck there");
        std::vector<Eigen::Index> pairs = pairs_in_band(linear, p.eigen);
        if (pairs.size() > 1)
          pairs.resize(1);
        report_cut_off_damping(
          about.pressed, about.sliding, linear, pairs, p, context.log);
        return linear;
      }

      static TriggerResult
      without(const std::string &name, const std::string &status)
      {
        TriggerResult result;
        result.point  = name;
        result.status = status;
        return result;
      }

      TriggerResult
      result_at(const SteadyModel      &about,
                const LinearizedMotion &linear,
                const std::string      &name,
                const std::size_t       i,
                const Parameters       &p)
      {
        try
          {
            const TriggerResult result =
              find_trigger(about, linear, name, forces[i], p, context.timers);
            if (const std::string moment = moment_in(result); !moment.empty())
              context.log.warning(
                name + ": the normal forces cancel in their sum, and rms and " +
                "lines are those of the " + moment +
                " where columns of triggers.csv and trigger_motions.csv that "
                "end in 'judged_force' name one");
            return result;
          }
        catch (const ComputationError &e)
          {
            context.log.warning(name + ": " + e.what());
            return without(name, "a step has no solution");
          }
      }

      RunContext                     &context;
      const PressedScene              scene;
      const std::vector<unsigned int> places;
      const std::vector<ModalForce>   forces;
    };

    /** What a scene's motions depend on beside the entries of its run: where it
     * is struck. */
    void
    add_points(const Parameters &p, Fingerprint &fingerprint)
    {
      for (const unsigned int i : struck_points(p))
        {
          const MeasuredPointParameters &point = p.measurement.points[i];
          std::string                    text  = point.body;
          for (const Vector3 *x : {&point.position, &point.direction})
            for (const double value : *x)
              text += " " + shortest_text(value);
          fingerprint.add("struck at " + point.name, text);
        }
    }

    /** Finished scenes are kept; a signal ends the program after the one at
     * hand. */
    class TriggerCampaign
    {
    public:
      explicit TriggerCampaign(RunContext &c)
        : context(c)
        , groups(campaign_groups(c.parameters))
      {
        for (auto &group : groups)
          for (CampaignRun &run : group)
            add_points(run.parameters, run.fingerprint);
      }

      /** Tables of all scenes, one after the other. */
      std::vector<TriggerTables>
      run()
      {
        const std::vector<CampaignRun> runs = all_runs(groups);
        FinishedRuns finished = finished_runs(context, runs, trigger_record, 0);
        std::vector<TriggerTables> all;
        Progress                   progress(context.log, "scenes", runs.size());
        StopRequest                stop;
        const InputsAtStart        inputs;
        for (const auto &group : groups)
          {
            std::unique_ptr<StruckScene> scene;
            for (const CampaignRun &run : group)
              {
                TriggerTables tables;
                if (!take(finished, run, tables))
                  {
                    if (!scene)
                      scene =
                        std::make_unique<StruckScene>(run.parameters, context);
                    tables = tables_of(scene->results(run));
                    inputs.require_same();
                    if (context.is_root)
                      keep(finished, run, tables);
                  }
                for (Table *table :
                     {&tables.triggers, &tables.trials, &tables.motions})
                  put_place(*table, run, context.parameters);
                all.push_back(std::move(tables));
                progress.advance(1, run.top);
                if (stop.is_there())
                  {
                    context.log.info("stopped; the same command goes on with "
                                     "the scenes that are left");
                    stop.repeat();
                  }
              }
          }
        return all;
      }

    private:
      static bool
      take(const FinishedRuns &finished,
           const CampaignRun  &run,
           TriggerTables      &tables)
      {
        std::vector<Cell> cells;
        const auto take_one = [&](const std::string &name, Table &table) {
          const bool is_there = finished.find(run.fingerprint, name, 0, cells);
          if (is_there)
            add_rows(table, cells);
          return is_there;
        };
        return take_one(trigger_record, tables.triggers) &&
               take_one(trial_record, tables.trials) &&
               take_one(motion_record, tables.motions);
      }

      static void
      keep(FinishedRuns        &finished,
           const CampaignRun   &run,
           const TriggerTables &tables)
      {
        finished.add(run.fingerprint, motion_record, all_cells(tables.motions));
        finished.add(run.fingerprint, trial_record, all_cells(tables.trials));
        finished.add(
          run.fingerprint, trigger_record, all_cells(tables.triggers));
      }

      RunContext                           &context;
      std::vector<std::vector<CampaignRun>> groups;
    };



    /** Of one scene the sentence of the point that needs the smallest blow; of
     * several how many have a threshold as well. */
    std::string
    headline_of(const Table &triggers, const std::size_t n_scenes)
    {
      std::size_t n_found = 0, least = triggers.n_rows();
      for (std::size_t i = 0; i < triggers.n_rows(); ++i)
        if (!triggers.is_missing(i, "impulse_ns"))
          {
            ++n_found;
            if (least == triggers.n_rows() ||
                triggers.real(i, "impulse_ns") <
                  triggers.real(least, "impulse_ns"))
              least = i;
          }
      const std::string sentence =
        triggers.n_rows() == 0
          ? "nothing was struck"
          : trigger_sentence(triggers, n_found > 0 ? least : 0);
      return n_scenes == 1
               ? sentence
               : std::to_string(n_found) + " of " +
                   std::to_string(triggers.n_rows()) + " points of " +
                   std::to_string(n_scenes) + " scenes have a threshold" +
                   (n_found > 0 ? "; the least: " + sentence : "");
    }

    const std::string of_errors =
      " (errors by the bracket and half the steps; mesh and cut-off not "
      "estimated)";

    std::vector<std::pair<std::string, std::string>>
    figures_of_run(const Table &triggers, const std::size_t n_scenes)
    {
      std::vector<std::pair<std::string, std::string>> result{
        {"triggers", headline_of(triggers, n_scenes) + of_errors}};
      if (n_scenes == 1)
        for (std::size_t i = 0; i < triggers.n_rows(); ++i)
          result.emplace_back(triggers.text(i, "point"),
                              trigger_sentence(triggers, i));
      return result;
    }
  } // namespace



  void
  run_triggers(RunContext &context)
  {
    const Parameters &p = context.parameters;
    warn_of_drive(p, context.log);
    const std::vector<TriggerTables> scenes = TriggerCampaign(context).run();
    TriggerTables                    all    = scenes.front();
    for (std::size_t i = 1; i < scenes.size(); ++i)
      {
        all.triggers.append(scenes[i].triggers);
        all.trials.append(scenes[i].trials);
        all.motions.append(scenes[i].motions);
      }
    context.write_table("triggers.csv", all.triggers);
    context.write_table("trigger_trials.csv", all.trials);
    context.write_table("trigger_motions.csv", all.motions);
    std::ostringstream text;
    all.triggers.print(text);
    context.log.heading("Triggers");
    context.log.info(text.str());
    context.record.figures = figures_of_run(all.triggers, scenes.size());
    HtmlReport report("Triggers of " + p.scene.name,
                      "smallest impulses that lead to squeal");
    report.set_verdict(HtmlReport::Verdict::neutral,
                       context.record.figures.front().second,
                       context.record.figures);
    if (p.output.plots && context.is_root)
      {
        report.section("Either side of the threshold");
        if (!p.sweep.axes.empty())
          draw_branches(context, all.triggers, report);
        draw_motions(context, scenes.front().motions, report);
      }
    report.section("Triggers");
    report.table(all.triggers, "Thresholds and the cycles either side");
    report.section("Trials");
    report.table(all.trials, "Impulses that were tried");
    context.finish(p.output.report ? &report : nullptr, "");
  }
} // namespace squeal
