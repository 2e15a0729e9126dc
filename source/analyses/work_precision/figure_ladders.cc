// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/analyses/run_figures.h>
#include <squeal/analyses/work_precision/figure_ladders.h>
#include <squeal/analyses/work_precision/ladder.h>

#include <squeal/base/exceptions.h>
#include <squeal/base/timers.h>
#include <squeal/base/unknown_choice.h>
#include <squeal/output/headlines.h>
#include <squeal/parameters/choices.h>
#include <squeal/results/cost_at_error.h>
#include <squeal/results/plots.h>
#include <squeal/run/run_context.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>

namespace squeal
{
  namespace
  {
    using FigureLadder = WorkPrecisionParameters::Ladder;
    using Type         = Table::Type;

    struct FigureRung
    {
      double     setting;
      RunFigures solution;
    };

    /** One ladder, all of its rungs. */
    struct ClimbedLadder
    {
      FigureLadder            ladder;
      std::vector<FigureRung> rungs;
      std::size_t             finest = 0;

      /** How far a figure of one of the rungs is from that of the finest one,
       * relative to that or to its scale; of an error, that itself. NaN where
       * one of them is not there. */
      double
      error_of(const RunFigure &figure) const
      {
        if (figure.is_error)
          return std::abs(figure.value);
        const double reference = reference_of(figure);
        return figure.relative(figure.value - reference, reference);
      }

      double
      reference_of(const RunFigure &figure) const
      {
        return rungs[finest].solution.value_of(figure.name);
      }

      /** Whether @p rung tells an error of @p figure: not the reference. */
      bool
      counts(const std::size_t rung, const RunFigure &figure) const
      {
        return figure.is_error || rung != finest;
      }
    };

    /** The rung that stands for the truth of its ladder: of meshes the one with
     * most unknowns. */
    std::size_t
    finest_of(const FigureLadder ladder, const std::vector<FigureRung> &rungs)
    {
      const auto fineness = [&](const FigureRung &rung) {
        if (!rung.solution.is_solved())
          return -std::numeric_limits<double>::infinity();
        switch (ladder)
          {
          case FigureLadder::time_step:
            return -rung.setting;
          case FigureLadder::cut_off:
            return rung.setting;
          case FigureLadder::degree:
          case FigureLadder::refinement:
          case FigureLadder::cells:
          case FigureLadder::adaptive:
          case FigureLadder::basis:
            return static_cast<double>(rung.solution.n_unknowns);
          }
        unknown_choice("ladder");
      };
      return std::max_element(rungs.begin(),
                              rungs.end(),
                              [&](const FigureRung &a, const FigureRung &b) {
                                return fineness(a) < fineness(b);
                              }) -
             rungs.begin();
    }

    /** Solves @p p, made by parameters_of_rung(). */
    RunFigures
    solve_rung(const Parameters &p, RunContext &context)
    {
      const double start = cpu_seconds();
      RunFigures   rung  = p.analysis == Parameters::Analysis::transient
                             ? figures_of_transient(p, context.log, context.timers)
                             : figures_of_preload(p, context.timers);
      rung.seconds       = cpu_seconds() - start;
      rung.memory_mb     = peak_memory_mb();
      return rung;
    }

    /** A rung that cannot be solved, as one whose time step is not stable, has
     * no figures and says why. */
    RunFigures
    solve_or_tell(RunContext        &context,
                  const FigureLadder ladder,
                  const double       value)
    {
      const Parameters p =
        parameters_of_rung(context.parameters, ladder, value);
      const auto unsolved = [&](const std::string &reason) {
        context.log.warning(setting_text(ladder, value) +
                            " is not solved: " + reason);
        RunFigures rung;
        rung.verdict = "not solved: " + reason;
        return rung;
      };
      try
        {
          return solve_rung(p, context);
        }
      catch (const InputError &e)
        {
          return unsolved(e.what());
        }
      catch (const ComputationError &e)
        {
          return unsolved(e.what());
        }
    }

    ClimbedLadder
    climb_ladder(RunContext &context, const FigureLadder ladder)
    {
      ClimbedLadder climbed{ladder, {}};
      unsigned int  n_solved = 0;
      for (const double value : context.parameters.work_precision.rungs(ladder))
        {
          context.log.info(setting_text(ladder, value));
          climbed.rungs.push_back(
            {value, solve_or_tell(context, ladder, value)});
          n_solved += climbed.rungs.back().solution.is_solved();
        }
      if (n_solved < 2)
        throw ComputationError("the ladder '" + choice_name(ladder) +
                               "' has no two rungs that can be solved");
      climbed.finest = finest_of(ladder, climbed.rungs);
      return climbed;
    }

    std::vector<Cell>
    row_of_figure(const ClimbedLadder &climbed,
                  const FigureRung    &rung,
                  const RunFigure     &figure)
    {
      const RunFigures &s     = rung.solution;
      const double      error = climbed.error_of(figure);
      return {setting_text(climbed.ladder, rung.setting),
              s.n_unknowns,
              s.n_modes > 0 ? Cell(s.n_modes) : Cell(),
              s.n_steps > 0 ? Cell(s.n_steps) : Cell(),
              s.seconds,
              s.memory_mb,
              s.verdict,
              figure.name,
              or_missing(figure.value),
              std::isfinite(error) ? Cell(error) : Cell(),
              or_missing(figure.relative(figure.stated, figure.value)),
              figure.is_error
                ? "exact"
                : setting_text(climbed.ladder,
                               climbed.rungs[climbed.finest].setting)};
    }

    std::vector<Cell>
    unsolved_row(const FigureLadder ladder, const FigureRung &rung)
    {
      std::vector<Cell> row(12);
      row[0] = setting_text(ladder, rung.setting);
      row[6] = rung.solution.verdict;
      return row;
    }

    Table
    figure_table(const std::vector<ClimbedLadder> &ladders)
    {
      Table table(
        {{"setting", Type::text, "", "ladder and value"},
         {"dofs", Type::integer, "", "unknowns"},
         {"modes", Type::integer, "", "up to the cut-off of a transient"},
         {"steps", Type::integer, "", "of a transient"},
         {"seconds", Type::real, "s", "CPU time", 3},
         {"peak_memory_mb", Type::real, "MB", "of the process so far", 4},
         {"verdict", Type::text, "", "what the run says"},
         {"figure", Type::text, "", "column of preload.csv or transient.csv"},
         {"figure_value", Type::real, "", "in the unit of its name", 7},
         {"error_rel", Type::real, "", "against the reference", 3},
         {"stated_rel", Type::real, "", "error that the run states", 3},
         {"reference", Type::text, "", "what it is measured against"}});
      for (const ClimbedLadder &climbed : ladders)
        for (const FigureRung &rung : climbed.rungs)
          {
            if (!rung.solution.is_solved())
              table.add_row(unsolved_row(climbed.ladder, rung));
            for (const RunFigure &figure : rung.solution.figures)
              table.add_row(row_of_figure(climbed, rung, figure));
          }
      return table;
    }

    /** The points of one figure on one ladder. */
    WorkPrecisionSeries
    series_of(const ClimbedLadder &climbed, const std::string &name)
    {
      WorkPrecisionSeries series{choice_name(climbed.ladder), {}, {}, {}, {}};
      for (std::size_t k = 0; k < climbed.rungs.size(); ++k)
        for (const RunFigure &figure : climbed.rungs[k].solution.figures)
          if (const double error = climbed.error_of(figure);
              figure.name == name && climbed.counts(k, figure) && error > 0. &&
              std::isfinite(error))
            {
              const RunFigures &s = climbed.rungs[k].solution;
              series.seconds.push_back(s.seconds);
              series.dofs.push_back(s.n_unknowns);
              series.errors.push_back(error);
              series.settings.push_back(
                rounded_text(climbed.rungs[k].setting, 3));
            }
      return series;
    }

    /** What each ladder takes until a figure is within @p goal. */
    Table
    figure_costs(const std::vector<ClimbedLadder> &ladders,
                 const std::vector<std::string>   &names,
                 const double                      goal)
    {
      Table table(
        {{"ladder", Type::text, "", "ladder"},
         {"figure", Type::text, "", "column of preload.csv or transient.csv"},
         {"error_rel", Type::real, "", "error to be reached", 3},
         {"seconds", Type::real, "s", "CPU time it takes", 3},
         {"found", Type::text, "", "between rungs or beyond the finest"},
         {"largest_error_rel", Type::real, "", "of all rungs", 3},
         {"least_error_rel", Type::real, "", "of all rungs", 3}});
      for (const std::string &name : names)
        for (const ClimbedLadder &climbed : ladders)
          {
            const WorkPrecisionSeries s = series_of(climbed, name);
            if (s.errors.empty())
              continue;
            const auto cost = cost_at_error(s.seconds, s.errors, goal);
            const auto [least, largest] =
              std::minmax_element(s.errors.begin(), s.errors.end());
            table.add_row({s.label,
                           name,
                           goal,
                           cost ? Cell(cost->cost) : Cell(),
                           cost && cost->extrapolated ? "extrapolated"
                           : cost                     ? "interpolated"
                           : *largest <= goal         ? "by every rung"
                                                      : "not found",
                           *largest,
                           *least});
          }
      return table;
    }

    std::vector<std::string>
    names_of(const std::vector<ClimbedLadder> &ladders)
    {
      std::vector<std::string> names;
      for (const ClimbedLadder &climbed : ladders)
        for (const FigureRung &rung : climbed.rungs)
          for (const RunFigure &figure : rung.solution.figures)
            if (std::find(names.begin(), names.end(), figure.name) ==
                names.end())
              names.push_back(figure.name);
      return names;
    }

    /** Warns where rungs of one ladder do not say the same. */
    void
    warn_of_verdicts(const ClimbedLadder &climbed, RunLog &log)
    {
      const FigureRung &finest = climbed.rungs[climbed.finest];
      for (const FigureRung &rung : climbed.rungs)
        if (rung.solution.is_solved() &&
            rung.solution.verdict != finest.solution.verdict)
          log.warning(setting_text(climbed.ladder, rung.setting) + " says \"" +
                      rung.solution.verdict + "\", and " +
                      setting_text(climbed.ladder, finest.setting) +
                      " says \"" + finest.solution.verdict + "\"");
    }

    void
    draw_figures(RunContext                       &context,
                 const std::vector<ClimbedLadder> &ladders,
                 const std::vector<std::string>   &names,
                 HtmlReport                       &report)
    {
      for (const std::string &name : names)
        {
          std::vector<WorkPrecisionSeries> series;
          for (const ClimbedLadder &climbed : ladders)
            if (WorkPrecisionSeries s = series_of(climbed, name);
                !s.errors.empty())
              series.push_back(s);
          if (series.empty())
            continue;
          const std::string file = "plots/work_precision_" + name;
          context.output.file(file + ".png");
          const std::string path = context.output.path() + "/" + file;
          plot_work_precision(context.plotter,
                              series,
                              context.parameters.discretization.tolerance,
                              path,
                              "Error of " + name);
          report.figure(path + ".png", "Error of " + name + " against work");
        }
    }

    /** The same file's own check of every rung, before the first is climbed. */
    void
    check_rungs(const Parameters &parameters)
    {
      const auto &w = parameters.work_precision;
      for (const FigureLadder ladder : w.ladders)
        for (const double value : w.rungs(ladder))
          parameters_of_rung(parameters, ladder, value);
    }
  } // namespace



  void
  run_figure_ladders(RunContext &context)
  {
    const Parameters &p = context.parameters;
    check_rungs(p);
    std::vector<ClimbedLadder> ladders;
    for (const FigureLadder ladder : p.work_precision.ladders)
      ladders.push_back(climb_ladder(context, ladder));
    const std::vector<std::string> names = names_of(ladders);
    const Table                    table = figure_table(ladders);
    context.write_table("figure_errors.csv", table);
    std::ostringstream text;
    table.print(text,
                {"setting", "seconds", "figure", "figure_value", "error_rel"});
    context.log.info(text.str());
    for (const ClimbedLadder &climbed : ladders)
      warn_of_verdicts(climbed, context.log);
    const Table costs =
      figure_costs(ladders, names, p.discretization.tolerance);
    context.write_table("figure_costs.csv", costs);

    HtmlReport report("Work and precision of " + p.scene.name,
                      choice_name(p.work_precision.problem) +
                        ": error against cost");
    report.set_verdict(HtmlReport::Verdict::neutral,
                       figure_headline(costs),
                       {{"ladders", std::to_string(ladders.size())},
                        {"figures", std::to_string(names.size())}});
    report.section("Ladders");
    report.paragraph(
      "Each ladder varies one setting of the file and is compared with its own "
      "finest rung, whose error is not seen: where the finest two are close "
      "together, errors are too small.");
    report.table(costs, "Cost of an error");
    if (context.is_root && p.output.plots)
      draw_figures(context, ladders, names, report);
    report.table(table, "Figures of all rungs");
    context.finish(p.output.report ? &report : nullptr, "");
  }
} // namespace squeal
