// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_cycle_leading_run_h
#define squeal_cycle_leading_run_h

#include <squeal/cycle/motion_fate.h>
#include <squeal/cycle/orbit_forces.h>

#include <string>
#include <utility>
#include <vector>

namespace squeal
{
  /** What a motion does at the end of the time that it was followed for. */
  struct RunFigures
  {
    double time       = 0.; /**< s, that it was followed for; 0: not */
    double rms_normal = 0.; /**< of the normal resultant in the last part, N, or
                               of the moment that is judged, of the pair where
                               that is largest */
    std::string         judged_force; /**< that moment; empty: there is none */
    std::vector<double> rms_of_pairs; /**< the same rms of every pair */
    double              line = 0.; /**< Hz, largest of their spectra; 0: none */
    double frequency         = 0.; /**< Hz, of its period by the spectrum */
    double repetition        = 0.; /**< as repetition() of a signal */
    double recurrence = 1.;    /**< nearest return, over the mean distance */
    bool   lasts      = false; /**< the forces of the last three parts agree */
  };

  /**
   * A motion on its way to what it ends in, part by part.
   *
   * Its steps are those of PeriodMap::run_plainly(), as in a transient: located
   * changes of status make motions with many impacts gain energy where the
   * steps are as long as here.
   */
  class LeadingRun
  {
  public:
    /** References are kept. @p step: of time, at most the largest stable one, s;
     * @p part: length of a part, rounded to whole steps, s; @p longest: of all
     * parts, s, of which there are at least two; @p shortest: the shortest
     * time that counts as a return, s. */
    LeadingRun(const PeriodMap &map,
               MotionPlace      start,
               const double     step,
               const double     part,
               const double     longest,
               const double     shortest);

    /** Another part; false where the time is over. Throws ComputationError
     * where a step has no solution. */
    bool advance();

    /** Whether the last part comes back to within a tenth of the mean distance
     * and its forces are within 2 % of those of the part before. */
    bool has_settled() const;

    /** Whether the forces of the last three parts are within a tenth of their
     * mean. */
    bool lasts() const;

    /** Whether a small disturbance of the motion grows clearly over the last
     * three parts, so that the motion does not settle there: followed again
     * from their start with velocities that are larger by a trace. A shift in
     * time is taken off: while the amplitude settles, the frequency changes
     * with it. Throws ComputationError where a step has no solution. */
    bool disturbance_grows() const;

    /** Whether the nearest return of the last part is about as far as that of
     * the part at half the time; of at least three parts. */
    bool has_stopped_nearing() const;

    /** See recurrences(), of the last part. */
    const std::vector<std::pair<double, double>> &
    returns() const
    {
      return last_returns;
    }
    /** The nearest of them, over the mean distance; 1 without. */
    double nearest_return() const;

    const MotionPlace &
    end() const
    {
      return place;
    }

    /** Forces of the last three parts at most, N. */
    PairForces resultants() const;

    /** Judged by what the last part vibrates by, or by @p rows. */
    RunFigures figures() const;
    RunFigures figures(const JudgedRows &rows) const;

  private:
    const PeriodMap   &map;
    MotionPlace        place;
    const double       dt;
    const unsigned int n_steps; /**< of a part */
    const double       longest, shortest;
    /** See rms_forces_of(), of each part, N. */
    std::vector<double>     rms_forces;
    std::vector<PairForces> last_forces; /**< of three parts */
    /** Of a part: what tells a disturbance from a shift in time. */
    struct PartEnds
    {
      MotionPlace start;
      MotionState one_before, end; /**< the last two states */
    };
    std::vector<PartEnds>                  last_ends; /**< of three parts */
    std::vector<double>                    nearest;   /**< of each part */
    std::vector<std::pair<double, double>> last_returns;
    double                                 time = 0.; /**< of all parts */
  };
} // namespace squeal

#endif
