// SPDX-License-Identifier: LGPL-2.1-or-later

// Whether motions from other starts end in the cycle that is heard.

#include <squeal/analyses/limit_cycle/cycle_campaign.h>
#include <squeal/analyses/limit_cycle/cycle_columns.h>
#include <squeal/analyses/limit_cycle/cycle_trials.h>
#include <squeal/base/exceptions.h>
#include <squeal/base/number_text.h>
#include <squeal/output/judged_force.h>
#include <squeal/results/column_of.h>
#include <squeal/transient/modal_step.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace squeal
{
  namespace
  {
    using Type = Table::Type;

    /** A motion may go on for so many times the run before. */
    constexpr double longest_over_run = 2.;
    /** A small one may grow for so many times that beforehand. */
    constexpr double longest_growth = 10.;

    /** 1, 4, 1/4, 16, 1/16 ... */
    double
    energy_ratio(const unsigned int i)
    {
      return std::pow(4., (i % 2 == 1 ? 1. : -1.) * ((i + 1) / 2));
    }

    struct TrialRow
    {
      const MotionTrial &trial;
      const CycleResult &cycle;
    };

    using TrialColumn = ColumnOf<TrialRow>;

    std::vector<TrialColumn>
    columns_of_trials()
    {
      const auto of_motion = [](const Table::Column &declaration,
                                double RunFigures::*number) {
        return TrialColumn{declaration, [number](const TrialRow &row) {
                             return Cell(row.trial.figures.*number);
                           }};
      };
      return {
        {{"start", Type::text, "", "of the motion"},
         [](const TrialRow &row) { return Cell(row.trial.start); }},
        {{"ends_in_cycle",
          Type::text,
          "",
          "line and rms stay those of the cycle"},
         [](const TrialRow &row) {
           return Cell(std::string(row.trial.ends_in        ? "yes"
                                   : row.trial.has_failed   ? "no solution"
                                   : row.trial.is_undecided ? "undecided"
                                                            : "no"));
         }},
        {{"time_s", Type::real, "s", "that the motion was followed for"},
         [](const TrialRow &row) { return Cell(row.trial.time); }},
        {{"periods",
          Type::real,
          "",
          "of the cycle, in which it had its line and rms at the end",
          3},
         [](const TrialRow &row) { return Cell(row.trial.periods); }},
        {{"frequency_hz",
          Type::real,
          "Hz",
          "its largest line over the number of the cycle's nearest harmonic",
          6},
         [](const TrialRow &row) { return Cell(row.trial.frequency); }},
        of_motion({"rms_normal_n", Type::real, "N", "of its normal force"},
                  &RunFigures::rms_normal),
        of_motion(
          {"run_line_hz", Type::real, "Hz", "largest line of its normal force"},
          &RunFigures::line),
        of_motion({"repetition", Type::real, "", "of its normal force", 3},
                  &RunFigures::repetition),
        {{"cycle_frequency_hz",
          Type::real,
          "Hz",
          "1/shortest period of the cycle",
          6},
         [](const TrialRow &row) {
           return Cell(row.cycle.figures.repetitions() *
                       row.cycle.figures.frequency);
         }},
        {{"cycle_rms_normal_n", Type::real, "N", "of the cycle's normal force"},
         [](const TrialRow &row) {
           return Cell(row.cycle.figures.rms_normal);
         }},
        {judged_force_column("judged_force"), [](const TrialRow &row) {
           return judged_force_cell(row.cycle.figures.judged_force);
         }}};
    }

    /** What small disturbances of steady sliding grow to: the pair that grows
     * fastest, from the amplitude at which the first node changes its status.
     * It may take as long as it needs from there to where the runs begin. */
    struct SmallMotion
    {
      std::string name;
      MotionState state;
      double      growth = 0.; /**< s */
    };

    /** Nothing where it takes too long, or where no node moves. */
    std::optional<SmallMotion>
    small_motion(const SteadySliding        &steady,
                 const PeriodMap            &map,
                 const LinearizedMotion     &linear,
                 const Eigen::Index          fastest,
                 const LimitCycleParameters &settings,
                 const double                longest)
    {
      try
        {
          const StartAmplitudes amplitudes =
            start_amplitudes(map, steady, linear, fastest, settings.run_steps);
          const std::complex<double> lambda = linear.lambda[fastest];
          const double               ratio =
            settings.start * amplitudes.half_change / amplitudes.first_change;
          const double growth = std::max(std::log(ratio), 0.) / lambda.real();
          if (!(growth <= longest))
            return {};
          return SmallMotion{
            "growth of the pair at " +
              rounded_text(lambda.imag() / (2. * M_PI), 5) + " Hz",
            state_of_pair(steady, linear, fastest, amplitudes.first_change),
            growth};
        }
      catch (const ComputationError &)
        {
          return {};
        }
    }

    /** Without the small one and the one from the cycle itself. */
    std::vector<MotionTrial>
    from_other_starts(const SteadyModel              &about,
                      const CycleTrials              &beside,
                      const std::vector<CycleResult> &cycles,
                      const CycleResult              &cycle,
                      const LimitCycleParameters     &settings,
                      std::vector<MotionTrial>        result)
    {
      for (const CycleResult &c : cycles)
        if (result.size() < settings.starts && c.run.time > 0.)
          result.push_back(beside.follow(
            "pair at " + rounded_text(c.pair.imag() / (2. * M_PI), 5) + " Hz",
            c.run_end));
      for (unsigned int i = 0; result.size() < settings.starts; ++i)
        {
          const double sign = i % 2 == 0 ? 1. : -1.,
                       energy =
                         energy_ratio(i) * std::pow(cycle.half_change, 2);
          const Eigen::VectorXd v = sign * about.pressed.disturbance(energy);
          result.push_back(beside.follow(
            "impulse of " + rounded_text(energy, 3) + " J" +
              (sign < 0. ? ", reversed" : ""),
            {{about.sliding.coordinates, v, about.sliding.forces}, {}, 0.}));
        }
      return result;
    }
  } // namespace



  std::vector<int>
  candidates_of(const std::vector<CycleResult> &cycles)
  {
    const CycleOutcome outcome = outcome_of(cycles);
    if (outcome.heard >= 0)
      return {outcome.heard};
    if (!outcome.open.empty())
      {
        const auto error = [&cycles](const int i) {
          return cycles[i].rms_normal_error() / cycles[i].figures.rms_normal;
        };
        std::vector<int> open = outcome.open;
        std::stable_sort(
          open.begin(), open.end(), [&error](const int a, const int b) {
            return error(a) < error(b);
          });
        return open;
      }
    int least = -1;
    for (int i = 0; i < static_cast<int>(cycles.size()); ++i)
      if (cycles[i].has_converged() &&
          (least < 0 ||
           cycles[i].multipliers.largest < cycles[least].multipliers.largest))
        least = i;
    return least < 0 ? std::vector<int>() : std::vector<int>{least};
  }



  PointTrials
  trials_of(const SteadyModel              &about,
            const PeriodMap                &map,
            const LinearizedMotion         &linear,
            const Eigen::Index              fastest,
            const std::vector<CycleResult> &cycles,
            const std::vector<int>         &candidates,
            const LimitCycleParameters     &settings,
            const double                    step)
  {
    PointTrials result;
    if (settings.starts == 0 || candidates.empty())
      return result;
    const double longest = longest_over_run * settings.run_time;
    const auto   beside  = [&](const int cycle, const double growth = 0.) {
      return CycleTrials(map,
                         cycles[cycle],
                         largest_stable_step(map.reduced_model(), step),
                         growth + longest);
    };
    MotionTrial from_cycle;
    for (const int k : candidates)
      {
        const MotionTrial next = beside(k).follow_cycle(cycles[k].motion);
        if (result.cycle < 0 || next.ends_in)
          {
            result.cycle = k;
            from_cycle   = next;
          }
        if (next.ends_in)
          break;
      }
    if (const auto small = small_motion(about.sliding,
                                        map,
                                        linear,
                                        fastest,
                                        settings,
                                        longest_growth * longest))
      {
        result.motions.push_back(
          beside(result.cycle, small->growth)
            .follow(small->name, {small->state, {}, 0.}));
        result.motions.back().is_growth = true;
      }
    result.motions = from_other_starts(about,
                                       beside(result.cycle),
                                       cycles,
                                       cycles[result.cycle],
                                       settings,
                                       std::move(result.motions));
    result.motions.push_back(from_cycle);
    return result;
  }

  std::string
  growth_ends_in_cycle(const std::vector<MotionTrial> &motions)
  {
    const MotionTrial &growth = motions.front();
    if (!growth.is_growth || growth.has_failed || growth.is_undecided)
      return "not known";
    return growth.ends_in ? "yes" : "no";
  }

  Table
  trial_table_of(const PointTrials              &trials,
                 const std::vector<CycleResult> &cycles)
  {
    std::vector<TrialRow> rows;
    for (const MotionTrial &trial : trials.motions)
      rows.push_back({trial, cycles[trials.cycle]});
    return table_of(columns_of_trials(), rows);
  }
} // namespace squeal
