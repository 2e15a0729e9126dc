// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_cycle_cycle_trial_h
#define squeal_cycle_cycle_trial_h

#include <squeal/cycle/cycle_search.h>

#include <string>

namespace squeal
{
  /** What a motion from some start comes to beside a limit cycle. */
  struct MotionTrial
  {
    std::string start;              /**< in words */
    bool        ends_in    = false; /**< the cycle, by CycleTrials::follow() */
    bool        has_failed = false; /**< a step of it had no solution */
    double      time       = 0.;    /**< s, that it was followed for */
    /** Hz: its largest line over the harmonic of the cycle that is nearest. */
    double     frequency = 0.;
    RunFigures figures; /**< of its last parts */
  };

  /**
   * Motions from other starts beside a limit cycle, by the plain steps of
   * transients: a motion ends in the cycle if in four parts one after the
   * other, of twelve of the cycle's shortest periods each, the largest line of
   * its normal force is within 1 % of a harmonic of the cycle and the rms
   * within 5 % of the cycle's.
   */
  class CycleTrials
  {
  public:
    /** References are kept. @p step: s, at most the largest stable one; @p
     * longest: s, that a motion is followed for at most. */
    CycleTrials(const PeriodMap    &map,
                const CycleFigures &cycle,
                const double        step,
                const double        longest);

    /** A motion that has no solution at some step has failed: where it would
     * have ended is not known. */
    MotionTrial follow(const std::string &name, const MotionPlace &start) const;

    /** From a state of the cycle @p motion. */
    MotionTrial follow_cycle(const PeriodicMotion &motion) const;

  private:
    const PeriodMap    &map;
    const CycleFigures &cycle;
    const double        step, longest, shortest_period;
  };
} // namespace squeal

#endif
