// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_analyses_limit_cycle_cycle_trials_h
#define squeal_analyses_limit_cycle_cycle_trials_h

#include <squeal/cycle/cycle_trial.h>
#include <squeal/model/pressed_model.h>
#include <squeal/parameters/limit_cycle_parameters.h>
#include <squeal/results/table.h>
#include <squeal/transient/linearized_motion.h>

#include <string>
#include <vector>

namespace squeal
{
  /** Motions from other starts beside one of the cycles of a scene. */
  struct PointTrials
  {
    int cycle = -1; /**< which; -1: none */
    /** The last one from that cycle itself. */
    std::vector<MotionTrial> motions;
  };

  /** Which of @p cycles motions may end in: the one that is heard; else those
   * whose stability is open, by the errors of their rms forces; else the one of
   * the least multiplier; none where none was found. */
  std::vector<int> candidates_of(const std::vector<CycleResult> &cycles);

  /**
   * Motions from `Limit cycle/Starts` starts, by plain steps of @p step, s, or
   * the largest stable ones, and one from the cycle itself, beside the first of
   * @p candidates on which a motion stays, or the first of all. The first
   * motion is what a small disturbance of steady sliding grows to, by pair
   * @p fastest of @p linear, unless that takes too long; the next ones go on
   * from where the runs to @p cycles have ended, the others start from impulses
   * at points of all bodies of 1, 4, 1/4, 16, 1/16 ... times the energy at
   * which half of the nodes open or stick, in turn to either side. None without
   * starts and without candidates.
   */
  PointTrials trials_of(const SteadyModel              &about,
                        const PeriodMap                &map,
                        const LinearizedMotion         &linear,
                        const Eigen::Index              fastest,
                        const std::vector<CycleResult> &cycles,
                        const std::vector<int>         &candidates,
                        const LimitCycleParameters     &settings,
                        const double                    step);

  /** Whether what a small disturbance grows to ends in the cycle: `yes`, `no`
   * or `not known`. @p motions: of PointTrials, at least one. */
  std::string growth_ends_in_cycle(const std::vector<MotionTrial> &motions);

  /** A row for each motion, with the cycle beside it. */
  Table trial_table_of(const PointTrials              &trials,
                       const std::vector<CycleResult> &cycles);
} // namespace squeal

#endif
