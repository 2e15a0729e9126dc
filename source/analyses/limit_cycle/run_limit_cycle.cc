// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/analyses/limit_cycle/branch_output.h>
#include <squeal/analyses/limit_cycle/cycle_campaign.h>
#include <squeal/analyses/limit_cycle/cycle_columns.h>
#include <squeal/analyses/limit_cycle/cycle_motion.h>
#include <squeal/analyses/limit_cycle/cycle_trials.h>
#include <squeal/analyses/limit_cycle/kept_branches.h>
#include <squeal/analyses/limit_cycle/limit_cycle_branch.h>
#include <squeal/analyses/limit_cycle/limit_cycle_output.h>
#include <squeal/analyses/limit_cycle/pairs_to_follow.h>

#include <squeal/analyses/analyses.h>
#include <squeal/base/exceptions.h>
#include <squeal/base/number_text.h>
#include <squeal/model/drive_warnings.h>
#include <squeal/model/growth_outside.h>
#include <squeal/model/period_map_of.h>
#include <squeal/model/pressed_model.h>
#include <squeal/model/rotor_symmetry.h>
#include <squeal/model/strain_warnings.h>
#include <squeal/output/moving_pictures.h>
#include <squeal/output/record_unknowns.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>

namespace squeal
{
  namespace
  {
    /** Moments of the moving picture of a period. */
    constexpr unsigned int n_frames = 32;
    void
    log_cycles(RunLog &log, const Table &table)
    {
      log.heading("Limit cycles");
      std::ostringstream text;
      table.print(text,
                  {"pair_frequency_hz",
                   "pair_sigma_per_s",
                   "cycle_status",
                   "stability",
                   "frequency_hz",
                   "dominant_line_hz",
                   "rms_normal_n",
                   "largest_multiplier",
                   "residual",
                   "n_iterations"});
      log.info(text.str());
    }

    void
    warn_of_moments(RunLog &log, const Table &points)
    {
      std::size_t n = 0;
      for (std::size_t i = 0; i < points.n_rows(); ++i)
        n += !points.display(i, points.column_index("judged_force")).empty();
      if (n > 0)
        log.warning("rms and line of " + std::to_string(n) + " of " +
                    std::to_string(points.n_rows()) +
                    " points of the branch are those of a moment of the normal "
                    "forces, which cancel in their sum: 'judged_force' in "
                    "branch.csv");
    }

    /** Tables, picture and words of the branches over the axis of `Sweep`. */
    void
    report_branches(RunContext                     &context,
                    const BranchDiagram            &diagram,
                    const std::vector<std::string> &pairs,
                    HtmlReport                     &report)
    {
      const auto        &p     = context.parameters;
      const std::string &name  = p.sweep.axes.front().name;
      const Table        along = branch_table(diagram, pairs);
      context.write_table("branch.csv", along);
      if (p.limit_cycle.searches > 0)
        context.write_table("branch_searches.csv",
                            search_table(diagram.searches));
      // The first screen has a single one, and all together.
      if (diagram.branches.size() > 1)
        for (std::size_t i = 0; i < diagram.branches.size(); ++i)
          context.log.info("branch " + std::to_string(i + 1) + ": " +
                           branch_sentence(diagram.branches[i], name));
      warn_of_moments(context.log, along);
      if (const auto hidden = text_of_hidden_folds(diagram, name);
          !hidden.empty())
        context.log.warning(hidden);
      report.section("Branch");
      if (p.output.plots && context.is_root)
        draw_branches(context, diagram, p.sweep.axes.front(), report);
      report.table(along, "Limit cycles along the branch");
      if (!diagram.searches.empty())
        report.table(search_table(diagram.searches), "Searches along the axis");
    }

    /** What the brake comes to by itself, in words. */
    std::string
    text_of_growth(const PointTrials &trials, const CycleResult &cycle)
    {
      if (trials.motions.empty())
        return "not followed: 'Limit cycle/Starts = 1' tells whether they grow "
               "to this cycle";
      const MotionTrial &growth = trials.motions.front();
      const std::string  ends   = growth_ends_in_cycle(trials.motions);
      if (ends == "yes")
        return cycle.multipliers.is_unstable()
                 ? "come near this cycle, which is unstable by its "
                   "multipliers: where they end is not known"
                 : "grow to this cycle";
      if (ends == "not known")
        return "where they grow to is not known: raise 'Limit cycle/Run time'";
      return "grow to another motion, of " +
             rounded_text(growth.figures.rms_normal, 3) + " N rms with " +
             rounded_text(growth.figures.line, 5) +
             " Hz, which repeats itself to " +
             rounded_text(growth.figures.repetition, 3) +
             " (no error estimated)";
    }

    /** "3 of 4 end in this cycle; a motion from the cycle stays there"; the
     * last
     * of @p motions is that one. */
    std::string
    text_of_starts(const std::vector<MotionTrial> &motions)
    {
      const auto n = std::count_if(
                   motions.begin(),
                   motions.end() - 1,
                   [](const MotionTrial &x) { return x.ends_in; }),
                 n_undecided = std::count_if(
                   motions.begin(),
                   motions.end() - 1,
                   [](const MotionTrial &x) { return x.is_undecided; });
      return std::to_string(n) + " of " + std::to_string(motions.size() - 1) +
             " end in this cycle" +
             (n_undecided > 0
                ? ", " + std::to_string(n_undecided) + " undecided"
                : "") +
             "; a motion from the cycle " +
             (motions.back().ends_in ? "stays there" : "does not stay there");
    }

    /** The cycle that was asked for is that of @p trials. */
    void
    warn_of_trials(const PointTrials &trials,
                   const CycleResult &cycle,
                   RunLog            &log)
    {
      if (trials.motions.empty())
        return;
      if (growth_ends_in_cycle(trials.motions) == "no")
        log.warning("small disturbances of steady sliding " +
                    text_of_growth(trials, cycle) +
                    ", which a 'Limit cycle/Start amplitude' below 1 may find: "
                    "the brake does not come to this cycle by itself");
      if (cycle.multipliers.is_unstable() && trials.motions.back().ends_in)
        log.warning("the motion that starts on the cycle, which is unstable by "
                    "its multipliers, stays there for as long as it was "
                    "followed: it may leave later, or the multipliers are off, "
                    "which more 'Limit cycle/Steps per period' tell");
      if (cycle.multipliers.is_stable() && !trials.motions.back().ends_in)
        log.warning("the motion that starts on the cycle, which is stable by "
                    "its multipliers, does not stay there within the errors: "
                    "raise 'Limit cycle/Steps per period'");
    }

    std::vector<std::pair<std::string, std::string>>
    figures_of_run(const Table                    &table,
                   const CycleResult              &first,
                   const PointTrials              &trials,
                   const bool                      with_growth,
                   const std::vector<std::string> &pairs)
    {
      const auto shown = [&](const std::string &name) {
        const std::string text = table.display(0, table.column_index(name));
        return text.empty() ? std::string("-") : text;
      };
      std::vector<std::pair<std::string, std::string>> result = {
        {"limit cycle", cycle_sentence(first, pairs)},
        {"from the pair at",
         shown("pair_frequency_hz") + " Hz, sigma " +
           shown("pair_sigma_per_s") + " 1/s"}};
      const std::pair<std::string, std::string> residual = {
        "residual after a period",
        shown("residual") + ", " + shown("n_iterations") + " iterations"};
      if (!first.has_converged())
        {
          result.push_back(residual);
          return result;
        }
      const std::vector<std::pair<std::string, std::string>> more = {
        {"dominant line", shown("dominant_line_hz") + " Hz"},
        {"normal force",
         shown("mean_normal_n") + " +- " + shown("mean_normal_error_n") +
           " N, from " + shown("min_normal_n") + " +- " +
           shown("min_normal_error_n") + " to " + shown("max_normal_n") +
           " +- " + shown("max_normal_error_n") + " N"},
        {"nodes that open, that stick",
         shown("n_opening") + ", " + shown("n_sticking")},
        {"Floquet multipliers",
         "largest " + shown("largest_multiplier") + " +- " +
           shown("largest_multiplier_error") + ", the trivial one off 1 by " +
           shown("trivial_multiplier_error")},
        residual,
        {"penetration in the middle of steps",
         shown("penetration_m") + " m, gaps move by " + shown("gap_range_m") +
           " m"},
        {"share beyond the harmonics", shown("share_beyond_harmonics")},
        {"imbalance of the ledger", shown("imbalance")}};
      result.insert(result.end(), more.begin(), more.end());
      if (!trials.motions.empty())
        result.insert(
          result.begin() + 1,
          {"motions from other starts", text_of_starts(trials.motions)});
      if (with_growth)
        result.insert(result.begin() + 1,
                      {"small disturbances of steady sliding",
                       text_of_growth(trials, first)});
      return result;
    }

    /** Tables and report of @p cycles; the first is the one that was asked
     * for. */
    void
    report_cycles(RunContext                         &context,
                  const Model                        &model,
                  const SteadyModel                  &about,
                  const std::vector<CycleResult>     &cycles,
                  const PointTrials                  &trials,
                  const std::optional<BranchDiagram> &branches)
    {
      const auto                    &p     = context.parameters;
      const CycleResult             &first = cycles.front();
      const std::vector<std::string> pairs = names_of_pairs(p.scene);
      const unsigned int             n     = p.limit_cycle.harmonics;
      const Table                    table = cycle_table({first}, n, pairs);
      context.write_table("limit_cycle.csv", table);
      const Table all = cycle_table(cycles, n, pairs);
      if (p.limit_cycle.every_pair)
        context.write_table("competition.csv", all);
      log_cycles(context.log, all);
      for (const CycleResult &c : cycles)
        if (const std::string text = text_of_moment(c.figures, pairs);
            !text.empty())
          context.log.warning("the cycle from the pair at " +
                              rounded_text(c.pair.imag() / (2. * M_PI), 6) +
                              " Hz: " + text);
      warn_of_trials(trials, first, context.log);
      context.record.figures = figures_of_run(
        table, first, trials, !branches && first.has_converged(), pairs);
      if (branches)
        context.record.figures.insert(
          context.record.figures.begin(),
          {"branches", diagram_sentence(*branches, p.sweep.axes.front().name)});
      HtmlReport report("Limit cycle of " + p.scene.name,
                        "periodic motion of the reduced model");
      report.set_verdict(
        first.has_converged() && first.multipliers.is_stable()
          ? HtmlReport::Verdict::bad
          : HtmlReport::Verdict::neutral,
        branches ? diagram_sentence(*branches, p.sweep.axes.front().name)
                 : cycle_sentence(first, pairs),
        context.record.figures);
      if (first.has_converged())
        {
          const Table harmonics   = harmonic_table(first, n, pairs);
          const Table multipliers = multiplier_table(first);
          context.write_table("limit_cycle_period.csv",
                              period_table(first, pairs));
          context.write_table("limit_cycle_harmonics.csv", harmonics);
          context.write_table("limit_cycle_multipliers.csv", multipliers);
          if (p.output.plots && context.is_root)
            draw_cycle(context, first, report);
          if (p.output.report)
            {
              Timers::Section section(context.timers, "Write: motion");
              report.section("Motion");
              show_frames(context,
                          model,
                          motion_of_cycle(about, first.motion.orbit, n_frames),
                          "One period",
                          report);
            }
          report.section("Harmonics");
          report.table(harmonics,
                       "Amplitudes of the resultants, of the " +
                         judged_force_text(first.figures, pairs));
          report.section("Floquet multipliers");
          report.table(multipliers, "Multipliers above a thousandth");
        }
      if (branches)
        report_branches(context, *branches, pairs, report);
      report.section("Cycles");
      report.table(all, "Limit cycles of the growing pairs");
      if (!trials.motions.empty())
        {
          const Table starts = trial_table_of(trials, cycles);
          context.write_table("starts.csv", starts);
          report.section("Starts");
          report.table(starts, "Motions from other starts");
        }
      context.finish(p.output.report ? &report : nullptr, "");
    }
  } // namespace



  void
  run_limit_cycle(RunContext &context)
  {
    warn_of_drive(context.parameters, context.log);
    if (context.parameters.limit_cycle.campaign)
      {
        run_cycle_campaign(context);
        return;
      }
    Parameters p = context.parameters;
    for (auto &contact : p.scene.contacts)
      contact.state = ContactParameters::State::full;
    if (!p.sweep.axes.empty())
      require_on_axis(p);
    Model model(p, context.timers, {}, Model::Contacts::open);
    model.print_summary(context.log);
    warn_of_frozen_rotors(model, context.log);
    const auto earlier =
      p.sweep.axes.empty() ? std::nullopt : modes_of_branch(context);
    const SteadyModel about = pressed_model(p,
                                            model,
                                            p.transient.cut_off,
                                            context.timers,
                                            p.transient.interface_cut_off,
                                            earlier ? &*earlier : nullptr)
                                .steady(p.preload.tolerance, context.timers);
    const PressedModel  &pressed = about.pressed;
    const SteadySliding &steady  = about.sliding;
    warn_of_large_strains(p.scene, pressed, steady, context.log);
    record_unknowns(model, context.record);
    LinearizedMotion linear;
    {
      Timers::Section section(context.timers, "Solve: linearised motion");
      linear = motions_about(about);
    }
    const std::vector<Eigen::Index> pairs =
      pairs_to_follow(linear, p.eigen, p.limit_cycle);
    context.log.key_values(
      {{"modes up to the cut-off", std::to_string(pressed.model().n_modes())},
       {"contact nodes", std::to_string(pressed.model().n_nodes())},
       {"closed in steady sliding", std::to_string(steady.n_closed())},
       {"pairs to follow", std::to_string(pairs.size())}});
    const std::string outside =
      text_of_growth_outside(growth_outside(about, linear, p, context.timers));
    if (pairs.empty())
      throw ComputationError(
        "no pair of the band grows about steady sliding: there is nothing to "
        "start a limit cycle from" +
        (outside.empty() ? "" : "; " + outside));
    if (!outside.empty())
      context.log.warning(outside + ": no limit cycle is sought from it");
    report_cut_off_damping(
      pressed, steady, linear, growing_pairs(linear, p.eigen), p, context.log);
    const PeriodMap          map = period_map_of(about);
    std::vector<CycleResult> cycles;
    {
      Timers::Section section(context.timers, "Solve: limit cycles");
      Progress        progress(context.log, "growing pairs", pairs.size());
      for (const Eigen::Index k : pairs)
        {
          cycles.push_back(find_cycle(map, steady, linear, k, p.limit_cycle));
          if (!cycles.back().broken_off.empty())
            context.log.warning(cycles.back().broken_off);
          progress.advance();
        }
    }
    std::optional<BranchDiagram> branches;
    if (!p.sweep.axes.empty() &&
        (cycles.front().has_converged() || p.limit_cycle.searches > 0))
      branches = branches_of(context, pressed, cycles.front());
    PointTrials trials;
    if (p.limit_cycle.starts > 0 && cycles.front().has_converged())
      {
        Timers::Section section(context.timers, "Solve: other starts");
        trials = trials_of(about,
                           map,
                           linear,
                           growing_pairs(linear, p.eigen).front(),
                           cycles,
                           {0},
                           p.limit_cycle,
                           p.transient.time_step);
      }
    report_cycles(context, model, about, cycles, trials, branches);
  }
} // namespace squeal
