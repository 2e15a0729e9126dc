// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_cycle_edge_trajectory_h
#define squeal_cycle_edge_trajectory_h

#include <squeal/cycle/motion_fate.h>

#include <utility>
#include <vector>

namespace squeal
{
  struct EdgeSettings
  {
    double time = 0.1; /**< s; no restart after it, no stretch is longer */
    unsigned int halvings = 8;        /**< at each restart */
    double lowest = 0., highest = 0.; /**< Hz, of the band of its frequency */
  };

  /** Motions either side of the edge between what returns and what squeals. */
  struct EdgeTrajectory
  {
    enum class Status
    {
      followed,
      lost /**< two motions go apart however near they start */
    };
    /** From one restart to the next: the motions that return and squeal. */
    struct Stretch
    {
      std::vector<MotionWindow> lower, upper;
    };

    Status               status = Status::followed;
    std::vector<Stretch> stretches;
    Orbit                tail;     /**< the last one, below the edge */
    double               end = 0.; /**< s, when it ends */
    /** Of the tail: 1/period, Hz, 0: none; how well it repeats itself with it,
     * 1: exactly. */
    double frequency = 0., repetition = 0.;
    double rms_normal = 0.; /**< N, of the normal resultant or the moment that
                               is judged, whole periods */
    double      mean_normal = 0.; /**< N, of the normal resultant */
    std::string judged_force;     /**< that moment; empty: there is none */
  };

  std::string edge_text(const EdgeTrajectory::Status status);

  /**
   * Follows the edge between @p lower, which returns, and @p upper, at one
   * time, which squeals with the forces @p lasting, N: the way between both is
   * halved, each time keeping the half whose ends have different fates, the two
   * motions are followed side by side while their forces agree within 5 %, and
   * from there it is halved again. Middles of states keep the contact law, as
   * Coulomb's cone is convex.
   *
   * Skufca, Yorke and Eckhardt 2006 (doi:10.1103/PhysRevLett.96.174101).
   */
  EdgeTrajectory follow_edge(const MotionFollower &follower,
                             MotionPlace           lower,
                             MotionPlace           upper,
                             const double          lasting,
                             const EdgeSettings   &settings);
} // namespace squeal

#endif
