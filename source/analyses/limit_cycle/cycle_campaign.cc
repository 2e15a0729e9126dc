// SPDX-License-Identifier: LGPL-2.1-or-later

// Limit cycles over the axes of `Sweep` and several tops.

#include <squeal/analyses/limit_cycle/cycle_campaign.h>
#include <squeal/analyses/limit_cycle/cycle_columns.h>
#include <squeal/analyses/limit_cycle/limit_cycle_branch.h>
#include <squeal/analyses/limit_cycle/limit_cycle_output.h>
#include <squeal/base/number_text.h>
#include <squeal/base/stop_request.h>
#include <squeal/model/growth_outside.h>
#include <squeal/model/pressed_scene.h>
#include <squeal/output/record_unknowns.h>
#include <squeal/results/chart.h>
#include <squeal/results/column_title.h>
#include <squeal/results/html_report.h>
#include <squeal/run/campaign_file.h>
#include <squeal/run/run_context.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <sstream>

namespace squeal
{
  namespace
  {
    using Type = Table::Type;

    /** Names of what a finished point keeps. */
    const std::string point_record  = "cycle point",
                      pairs_record  = "cycle pairs",
                      starts_record = "cycle starts";

    struct CampaignTables
    {
      Table points, pairs, starts;
    };

    CampaignTables
    without_sliding(const Parameters &p)
    {
      const std::vector<std::string> pairs = names_of_pairs(p.scene);
      return {outcome_without_sliding(pairs),
              cycle_table({}, p.limit_cycle.harmonics, pairs),
              trial_table_of({}, {})};
    }

    /** All points with one set of bodies. */
    class PointGroup
    {
    public:
      PointGroup(const Parameters &p, RunContext &c)
        : context(c)
        , scene(p, c.timers)
      {
        record_unknowns(scene.model, context.record);
      }

      /** Tables of a point without the values of its axes. */
      CampaignTables
      tables(const CampaignRun &run)
      {
        const Parameters &p = run.parameters;
        const auto        about =
          scene.find_steady(p.scene.contacts, context.log, context.timers);
        if (!about)
          return without_sliding(p);
        const LinearizedMotion          linear = motions_about(*about);
        const std::vector<Eigen::Index> growing =
          growing_pairs(linear, p.eigen);
        const GrowthOutside outside =
          growth_outside(*about, linear, p, context.timers);
        if (const std::string text = text_of_growth_outside(outside);
            !text.empty())
          context.log.warning(place_of(run) + text +
                              ": no limit cycle is sought from it");
        if (p.transient.cut_off_damping > 0. && !growing.empty())
          context.log.info("  " + place_of(run));
        report_cut_off_damping(
          about->pressed, about->sliding, linear, growing, p, context.log);
        std::vector<CycleResult>       cycles;
        const std::vector<std::string> pairs = names_of_pairs(p.scene);
        for (const Eigen::Index k : growing)
          {
            cycles.push_back(cycle_of(*about, linear, k, p.limit_cycle));
            if (const std::string text =
                  text_of_moment(cycles.back().figures, pairs);
                !text.empty())
              context.log.warning(place_of(run) + text);
            if (cycles.back().may_settle())
              context.log.info("  " + place_of(run) +
                               cycle_sentence(cycles.back(), pairs));
          }
        Timers::Section   section(context.timers, "Solve: other starts");
        const PointTrials trials = trials_of(*about,
                                             period_map_of(*about),
                                             linear,
                                             growing.empty() ? 0 : growing[0],
                                             cycles,
                                             candidates_of(cycles),
                                             p.limit_cycle,
                                             p.transient.time_step);
        return {outcome_table(cycles, trials, pairs, outside.fastest()),
                cycle_table(cycles, p.limit_cycle.harmonics, pairs),
                trial_table_of(trials, cycles)};
      }

    private:
      /** "mu = 0.3, held: " of the point of @p run. */
      std::string
      place_of(const CampaignRun &run) const
      {
        const auto &axes = context.parameters.sweep.axes;
        std::string text;
        for (std::size_t a = 0; a < axes.size(); ++a)
          text += (text.empty() ? "" : ", ") + axes[a].name + " = " +
                  rounded_text(run.shown.at(a), 5);
        if (!run.top.empty())
          text += (text.empty() ? "" : ", ") + run.top;
        return text.empty() ? text : text + ": ";
      }

      /** The log says why a search has broken off. */
      CycleResult
      cycle_of(const SteadyModel          &about,
               const LinearizedMotion     &linear,
               const Eigen::Index          k,
               const LimitCycleParameters &settings)
      {
        Timers::Section section(context.timers, "Solve: limit cycles");
        CycleResult     result =
          find_cycle(period_map_of(about), about.sliding, linear, k, settings);
        if (!result.broken_off.empty())
          context.log.warning(result.broken_off);
        return result;
      }

      RunContext        &context;
      const PressedScene scene;
    };



    /** Fills @p at, which has the columns, with what an earlier campaign has
     * found; false if there is nothing. */
    bool
    find_finished(const FinishedRuns &finished,
                  const CampaignRun  &run,
                  CampaignTables     &at)
    {
      std::vector<Cell> row, pairs, starts;
      if (!finished.find(
            run.fingerprint, point_record, at.points.columns().size(), row))
        return false;
      finished.find(run.fingerprint, pairs_record, 0, pairs);
      finished.find(run.fingerprint, starts_record, 0, starts);
      at.points = Table(at.points.columns());
      add_rows(at.points, row);
      add_rows(at.pairs, pairs);
      add_rows(at.starts, starts);
      return true;
    }

    /** First what a point is not complete without. */
    void
    keep_finished(FinishedRuns         &finished,
                  const CampaignRun    &run,
                  const CampaignTables &at)
    {
      finished.add(run.fingerprint, pairs_record, all_cells(at.pairs));
      finished.add(run.fingerprint, starts_record, all_cells(at.starts));
      finished.add(run.fingerprint, point_record, all_cells(at.points));
    }

    /** Runs what is not finished. */
    CampaignTables
    tables_of(RunContext                                  &context,
              const std::vector<std::vector<CampaignRun>> &groups,
              FinishedRuns                                &finished,
              const std::size_t                            n_points)
    {
      const Parameters &p = context.parameters;
      CampaignTables    all;
      Progress          progress(context.log, "points", n_points);
      StopRequest       stop;
      InputsAtStart     inputs;
      for (const auto &runs : groups)
        {
          std::unique_ptr<PointGroup> group;
          for (const CampaignRun &run : runs)
            {
              CampaignTables at = without_sliding(p);
              if (!find_finished(finished, run, at))
                {
                  if (!group)
                    group =
                      std::make_unique<PointGroup>(run.parameters, context);
                  at = group->tables(run);
                  inputs.require_same();
                  if (context.is_root)
                    keep_finished(finished, run, at);
                }
              for (Table *table : {&at.points, &at.pairs, &at.starts})
                put_place(*table, run, p);
              all.points.append(at.points);
              all.pairs.append(at.pairs);
              all.starts.append(at.starts);
              progress.advance(1, run.top);
              if (stop.is_there())
                {
                  context.log.info("stopped; the same command goes on with the "
                                   "points that are left");
                  stop.repeat();
                }
            }
        }
      return all;
    }



    /** "14 of 36 points have growing pairs; steady sliding: 22, ..." */
    std::string
    campaign_sentence(const Table &points)
    {
      std::map<std::string, std::size_t> outcomes;
      std::size_t                        n_growing = 0;
      for (std::size_t i = 0; i < points.n_rows(); ++i)
        {
          ++outcomes[points.text(i, "outcome")];
          n_growing += points.integer(i, "n_growing") > 0;
        }
      std::string text = std::to_string(n_growing) + " of " +
                         std::to_string(points.n_rows()) +
                         " points have growing pairs";
      std::string listed;
      for (const auto &[outcome, n] : outcomes)
        listed +=
          (listed.empty() ? "" : ", ") + outcome + ": " + std::to_string(n);
      return text + "; " + listed +
             " (errors of the time steps; mesh and cut-off not estimated)";
    }

    /** Warns where a motion does not stay on the cycle that it starts on,
     * though its multipliers call it stable. */
    void
    warn_of_cycles_left(const Table &points, RunLog &log)
    {
      if (!points.has_column("stays"))
        return;
      std::size_t n = 0;
      for (std::size_t i = 0; i < points.n_rows(); ++i)
        n +=
          points.text(i, "stays") == "no" && points.integer(i, "n_stable") > 0;
      if (n > 0)
        log.warning(
          "at " + std::to_string(n) + " of " + std::to_string(points.n_rows()) +
          " points the motion that starts on a cycle that is stable by its "
          "multipliers does not stay there within the errors ('stays' = no in "
          "campaign.csv): raise 'Limit cycle/Steps per period'");
    }

    /** Warns where a brake that slides steadily does not come to the cycle that
     * is heard by itself. */
    void
    warn_of_other_growth(const Table &points, RunLog &log)
    {
      if (!points.has_column("growth_ends_in_cycle"))
        return;
      std::size_t n = 0;
      for (std::size_t i = 0; i < points.n_rows(); ++i)
        n += points.text(i, "growth_ends_in_cycle") == "no";
      if (n > 0)
        log.warning(
          "at " + std::to_string(n) + " of " + std::to_string(points.n_rows()) +
          " points small disturbances of steady sliding grow to another motion "
          "than the cycle ('growth_ends_in_cycle' = no in campaign.csv, "
          "'growth of the pair' in starts.csv), which larger starts lead to: "
          "a 'Limit cycle/Start amplitude' below 1 may find that motion");
    }

    /** Warns where motions had not yet come to the cycle that they approach. */
    void
    warn_of_undecided_motions(const Table &points, RunLog &log)
    {
      if (!points.has_column("n_undecided"))
        return;
      std::size_t n = 0, n_motions = 0;
      for (std::size_t i = 0; i < points.n_rows(); ++i)
        if (!points.is_missing(i, "n_undecided"))
          {
            n += points.integer(i, "n_undecided") > 0;
            n_motions += points.integer(i, "n_undecided");
          }
      if (n > 0)
        log.warning(std::to_string(n_motions) +
                    " motions from other starts at " + std::to_string(n) +
                    " of " + std::to_string(points.n_rows()) +
                    " points were still on their way to the cycle when their "
                    "time was over ('n_undecided' in campaign.csv): raise "
                    "'Limit cycle/Run time'");
    }

    /** Warns where nothing was found, as nothing follows from that. */
    void
    warn_of_points_without_cycle(const Table &points, RunLog &log)
    {
      std::size_t n = 0;
      for (std::size_t i = 0; i < points.n_rows(); ++i)
        n += points.text(i, "outcome") == "no limit cycle found";
      if (n > 0)
        log.warning("at " + std::to_string(n) + " of " +
                    std::to_string(points.n_rows()) +
                    " points no limit cycle was found, which says nothing "
                    "about whether there is one: where a motion may still "
                    "have been settling the log names the 'Limit cycle/Run "
                    "time' that would tell");
    }

    /** The line that is heard over the first axis, one series for each value of
     * the others. */
    void
    draw_points(RunContext &context, const Table &points, HtmlReport &report)
    {
      const Parameters                  &p = context.parameters;
      std::map<std::string, ChartSeries> series;
      for (std::size_t i = 0; i < points.n_rows(); ++i)
        {
          const double line = points.real(i, "dominant_line_hz");
          if (!std::isfinite(line))
            continue;
          std::string label;
          for (std::size_t a = 1; a < p.sweep.axes.size(); ++a)
            label += (label.empty() ? "" : ", ") +
                     ColumnTitle(points.columns()[a])
                       .with(points.real(i, p.sweep.axes[a].name));
          if (points.has_column("top"))
            label += (label.empty() ? "" : ", ") + points.text(i, "top");
          const bool is_stable = points.integer(i, "n_stable") > 0;
          label += (label.empty() ? "" : ", ") +
                   std::string(is_stable ? "stable" : "stability open");
          ChartSeries &s = series[label];
          s.label        = label;
          s.hollow       = !is_stable;
          s.x.push_back(points.real(i, p.sweep.axes[0].name));
          s.y.push_back(line);
        }
      if (series.empty())
        return;
      Chart chart;
      chart.title   = "Largest line of the limit cycles";
      chart.x.label = shown_title(p.sweep.axes[0], p.scene);
      chart.y.label = "frequency in Hz";
      for (auto &[label, s] : series)
        {
          s.ink    = series_ink(chart.series.size());
          s.marker = static_cast<ChartSeries::Marker>(chart.series.size() % 4);
          chart.series.push_back(s);
        }
      context.output.file("plots/campaign.png");
      const std::string path = context.output.path() + "/plots/campaign";
      context.plotter.draw(draw_charts({chart}), path);
      report.section("What is heard");
      report.figure(path + ".png",
                    "The largest line of the normal force, or of the moment of "
                    "it that is judged, in the stable limit cycle, or in the "
                    "only one whose stability is left open (hollow)",
                    true);
    }
  } // namespace



  void
  run_cycle_campaign(RunContext &context)
  {
    const Parameters              &p        = context.parameters;
    const auto                     groups   = campaign_groups(p);
    const std::vector<CampaignRun> runs     = all_runs(groups);
    FinishedRuns                   finished = finished_runs(
      context, runs, point_record, without_sliding(p).points.columns().size());
    const CampaignTables tables =
      tables_of(context, groups, finished, runs.size());
    context.write_table("campaign.csv", tables.points);
    context.write_table("competition.csv", tables.pairs);
    if (p.limit_cycle.starts > 0)
      context.write_table("starts.csv", tables.starts);
    std::ostringstream text;
    tables.points.print(text);
    context.log.heading("Campaign of limit cycles");
    context.log.info(text.str());
    warn_of_cycles_left(tables.points, context.log);
    warn_of_other_growth(tables.points, context.log);
    warn_of_undecided_motions(tables.points, context.log);
    warn_of_points_without_cycle(tables.points, context.log);
    context.record.figures = {
      {"limit cycles", campaign_sentence(tables.points)},
      {"points", std::to_string(tables.points.n_rows())},
      {"growing pairs", std::to_string(tables.pairs.n_rows())}};
    HtmlReport report("Limit cycles of " + p.scene.name,
                      "over the axes of the campaign");
    report.set_verdict(HtmlReport::Verdict::neutral,
                       context.record.figures.front().second,
                       context.record.figures);
    if (p.output.plots && context.is_root)
      {
        draw_points(context, tables.points, report);
        if (p.sweep.axes.size() == 2)
          draw_cycle_map(context, tables.points, report);
      }
    report.section("Points");
    report.table(tables.points, "What the growing pairs of each point lead to");
    report.section("Cycles");
    report.table(tables.pairs, "Limit cycles of all growing pairs");
    if (p.limit_cycle.starts > 0)
      {
        report.section("Starts");
        report.table(tables.starts, "Motions from other starts");
      }
    context.finish(p.output.report ? &report : nullptr, "");
  }
} // namespace squeal
