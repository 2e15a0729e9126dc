// SPDX-License-Identifier: LGPL-2.1-or-later

// Whether motions from other starts end in the cycle that is heard.

#include <squeal/analyses/limit_cycle/cycle_campaign.h>
#include <squeal/base/number_text.h>
#include <squeal/results/column_of.h>
#include <squeal/transient/modal_step.h>

#include <cmath>

namespace squeal
{
  namespace
  {
    using Type = Table::Type;

    /** A motion may go on for so many times the run before. */
    constexpr double longest_over_run = 2.;

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
          "line within 1 % and rms within 5 % of the cycle's in 48 periods"},
         [](const TrialRow &row) {
           return Cell(std::string(row.trial.ends_in ? "yes" : "no"));
         }},
        {{"time_s", Type::real, "s", "that the motion was followed for"},
         [](const TrialRow &row) { return Cell(row.trial.time); }},
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
         }}};
    }
  } // namespace



  std::vector<MotionTrial>
  trials_of(const SteadyModel              &about,
            const PeriodMap                &map,
            const std::vector<CycleResult> &cycles,
            const LimitCycleParameters     &settings,
            const double                    step)
  {
    std::vector<MotionTrial> result;
    const int                heard = outcome_of(cycles).heard;
    if (settings.starts == 0 || heard < 0)
      return result;
    const CycleResult &cycle = cycles[heard];
    const CycleTrials  trials(map,
                             cycle.figures,
                             largest_stable_step(map.reduced_model(), step),
                             longest_over_run * settings.run_time);
    for (const CycleResult &c : cycles)
      if (result.size() < settings.starts && c.run.time > 0.)
        result.push_back(trials.follow(
          "pair at " + rounded_text(c.pair.imag() / (2. * M_PI), 5) + " Hz",
          c.run_end));
    for (unsigned int i = 0; result.size() < settings.starts; ++i)
      {
        const double energy = energy_ratio(i) * std::pow(cycle.half_change, 2);
        const Eigen::VectorXd v =
          (i % 2 == 0 ? 1. : -1.) * about.pressed.disturbance(energy);
        result.push_back(trials.follow(
          "impulse of " + std::string(i % 2 == 0 ? "" : "-") +
            rounded_text(energy, 3) + " J",
          {{about.sliding.coordinates, v, about.sliding.forces}, {}, 0.}));
      }
    result.push_back(trials.follow_cycle(cycle.motion));
    return result;
  }

  Table
  trial_table_of(const std::vector<MotionTrial> &trials,
                 const std::vector<CycleResult> &cycles)
  {
    std::vector<TrialRow> rows;
    for (const MotionTrial &trial : trials)
      rows.push_back({trial, cycles[outcome_of(cycles).heard]});
    return table_of(columns_of_trials(), rows);
  }
} // namespace squeal
