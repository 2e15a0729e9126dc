// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_analyses_triggers_trigger_search_h
#define squeal_analyses_triggers_trigger_search_h

#include <squeal/cycle/cycle_search.h>
#include <squeal/cycle/edge_trajectory.h>
#include <squeal/cycle/trigger_threshold.h>
#include <squeal/model/pressed_model.h>

#include <string>

namespace squeal
{
  class Timers;

  /** What blows at one point lead to. */
  struct TriggerResult
  {
    std::string          point;
    std::string          status; /**< in words */
    std::complex<double> pair;   /**< 1/s, of the largest sigma of all motions
                                    about steady sliding */
    /** N s, by the steps of the parameters and by half of them. */
    TriggerThreshold threshold, finer;
    /** After the largest impulse, and after those of the last bracket. */
    FollowedMotion strongest, below, above;
    EdgeTrajectory edge;
    CycleResult    stable;   /**< that the largest impulse ends in */
    CycleResult    unstable; /**< on the edge */

    /** Whether a bracket of the threshold is known. */
    bool has_threshold() const;
    bool has_edge() const;
    /** The bracket by half the steps; by the steps where there is none. */
    const TriggerThreshold &best() const;
    /** Half the bracket and the change with half the steps, N s; NaN where that
     * is not known. */
    double impulse_error() const;
  };

  /** The threshold at the point @p name, which a force of 1 N strikes with @p
   * unit, and what stands on the edge. @p linear: about the same steady sliding.
   * A status says where there is no threshold; a step without a solution throws
   * ComputationError. */
  TriggerResult find_trigger(const SteadyModel      &about,
                             const LinearizedMotion &linear,
                             const std::string      &name,
                             const ModalForce       &unit,
                             const Parameters       &parameters,
                             Timers                 &timers);
} // namespace squeal

#endif
