// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_cycle_cycle_branch_h
#define squeal_cycle_cycle_branch_h

#include <squeal/cycle/cycle_search.h>
#include <squeal/cycle/period_maps.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace squeal
{
  struct BranchPoint;

  struct BranchSettings
  {
    double           lower = 0., upper = 1.; /**< of the parameter */
    unsigned int     n_points = 50;          /**< at most, to either side */
    ShootingSettings shooting;
    /** Of the parameter to the first neighbour, over its range. */
    double first_step = 0.01;
    /** Of a step along the branch, as the root of the squares of the change of
     * the state over the size of the motion, of the relative change of the
     * period and of that of the parameter over its range. */
    double largest_step = 0.2, smallest_step = 1e-4;
    /** Of the branch from one step to the next, rad, in the same measure. */
    double largest_turn = M_PI / 3.;
    /** Of the largest multiplier, as half the steps tell it at the start. */
    double multiplier_error = 0.;
    /** Whether a point is one of another branch, which ends this one; empty:
     * there is no other. */
    std::function<bool(const BranchPoint &)> is_of_another;
  };

  /** Why a branch goes no further. */
  enum class BranchEnd
  {
    range,    /**< the parameter is at its end or has left it */
    points,   /**< there are as many as were asked for */
    onset,    /**< no node changes its status any more and no friction turns by
                 more than onset_turn: beyond, the motion is the linear one, of any
                 smaller size at one parameter */
    small,    /**< the motion has nearly vanished, though nodes still open */
    turn,     /**< it turns too sharply, however short the steps */
    joined,   /**< it goes on as another branch */
    not_found /**< the iterations do not converge */
  };

  /** Friction that turns by less over a period, rad, leaves the motion linear:
   * what the turn adds to Coulomb's law is of the square of this. */
  constexpr double onset_turn = 0.02;
  /** Where a node is about to open in steady sliding it does so at any
   * amplitude, and a branch that comes down takes as many steps as the
   * amplitude has decades. It ends at this share of its largest amplitude,
   * where the parameter has less than this share of its range to go until it
   * vanishes. */
  constexpr double small_amplitude = 1e-2, small_distance = 1e-4;

  struct BranchPoint
  {
    double         parameter = 0.;
    PeriodicMotion motion;
    /** Their error is that of the settings or what the trivial one misses 1
     * by. */
    FloquetMultipliers multipliers;
    CycleFigures       figures;
    /** The parameter turns back here: it is an extremum of the points. At a
     * fold a multiplier passes 1 as well. */
    bool turns_back = false, is_fold = false;
    /** A multiplier passes 1 between this point and the next one while the
     * parameter goes on the same way: there may be two folds between them. */
    bool hides_folds = false;
    /** Changes of status of all nodes in a period. */
    unsigned int n_changes = 0;
    /** Largest angle, rad, between the friction forces of a slipping node after
     * the first step and after another one of the period. */
    double friction_turn = 0.;
  };

  /** Periodic motions along the branch, from one end to the other. */
  struct CycleBranch
  {
    std::vector<BranchPoint> points;
    BranchEnd first_end = BranchEnd::not_found, last_end = BranchEnd::not_found;
  };

  std::string branch_end_text(const BranchEnd end);

  /** Whether @p point lies on @p branch: between two of its neighbouring points
   * with frequency and rms of its normal force between theirs, within a share
   * of 1e-4 and 1e-2. */
  bool lies_on(const CycleBranch &branch, const BranchPoint &point);

  /**
   * The branch of periodic motions through @p start at @p parameter, to both
   * sides, by steps of limited length along it (pseudo-arc-length): beside the
   * state and the period the parameter is an unknown, so that the branch turns
   * back at folds. How the end of a period changes with the parameter is a
   * difference quotient.
   *
   * Keller 1977; Seydel, Practical Bifurcation and Stability Analysis.
   */
  CycleBranch follow_branch(const PeriodMaps     &maps,
                            const PeriodicMotion &start,
                            const double          parameter,
                            const BranchSettings &settings);
} // namespace squeal

#endif
