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
    bool        is_growth  = false; /**< of a small disturbance, see there */
    bool        ends_in    = false; /**< the cycle, by CycleTrials::follow() */
    bool        has_failed = false; /**< a step of it had no solution */
    /** It was still on its way to the cycle when its time was over, so that
     * where it would have ended is not known. */
    bool   is_undecided = false;
    double time         = 0.; /**< s, that it was followed for */
    /** Hz: its largest line over the harmonic of the cycle that is nearest. */
    double     frequency = 0.;
    RunFigures figures;      /**< of its last parts */
    double     periods = 0.; /**< of the cycle, that it was there at last */

    /** Whether it is known not to end in the cycle. */
    bool
    ends_elsewhere() const
    {
      return !ends_in && !has_failed && !is_undecided;
    }
  };

  /**
   * Motions from other starts beside a limit cycle, by the plain steps of
   * transients. In parts of twelve of the cycle's shortest periods the largest
   * line of its normal force, or of the moment that the cycle is judged by,
   * over the nearest harmonic of the cycle, and its rms are compared with those
   * of the cycle: they may be off by its errors and 0.1 % and 1 %, and by 1 %
   * and 5 % at most. A motion ends in the cycle if it is there in four parts
   * one after the other and, where the largest multiplier may be above 1, in as
   * many as a disturbance takes to become a hundred times as large, at most 480
   * periods. A motion that is there when its time is over goes on until that is
   * decided. One that is not, but whose line is within 10 % and whose rms goes
   * towards that of the cycle and would come to within 5 % of it, or goes there
   * ever faster, is undecided, and so is one of fewer than three parts.
   */
  class CycleTrials
  {
  public:
    /** References are kept. @p step: s, at most the largest stable one; @p
     * longest: s, that a motion is followed for at most, beside what it has to
     * stay for beyond four parts and what it needs to stay for if it is there
     * at the end. */
    CycleTrials(const PeriodMap   &map,
                const CycleResult &cycle,
                const double       step,
                const double       longest);

    /** A motion that has no solution at some step has failed: where it would
     * have ended is not known. */
    MotionTrial follow(const std::string &name, const MotionPlace &start) const;

    /** From a state of the cycle @p motion. */
    MotionTrial follow_cycle(const PeriodicMotion &motion) const;

  private:
    bool is_there(const MotionTrial &trial) const;
    /** Whether a motion is on its way to the cycle, or may be; @p rms: of its
     * parts, N. */
    bool approaches(const MotionTrial         &trial,
                    const std::vector<double> &rms) const;

    const PeriodMap   &map;
    const CycleResult &cycle;
    const double       step, shortest_period;
    const unsigned int n_parts; /**< that a motion has to stay for */
    const double       longest;
  };
} // namespace squeal

#endif
