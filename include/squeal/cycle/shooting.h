// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_cycle_shooting_h
#define squeal_cycle_shooting_h

#include <squeal/cycle/period_map.h>

#include <string>
#include <utility>
#include <vector>

namespace squeal
{
  enum class CycleStatus
  {
    converged,
    not_converged,  /**< nothing is said about whether there is one */
    steady_sliding, /**< the iterations have ended there */
    no_period,      /**< the motion before does not come back to where it was */
    aperiodic       /**< the same, and it lasts: its forces no longer change */
  };

  std::string cycle_status_text(const CycleStatus status);

  /** What changes of status that were held, those of another motion, leave open
   * of one that is periodic with them. */
  struct HeldChanges
  {
    /** What it misses its start by with its changes located on it, in the
     * measure of its residual. */
    double residual = 0.;
    /** What the period and the motion change by for that, in a step of Newton's
     * method, in shares of the period and of the size of the motion. */
    double period = 0., motion = 0.;
  };

  /** A periodic motion, or what the iterations have made of one. */
  struct PeriodicMotion
  {
    CycleStatus         status = CycleStatus::not_converged;
    double              period = 0.; /**< s */
    Orbit               orbit;       /**< of one period */
    double              residual   = 0.;
    unsigned int        iterations = 0;
    std::vector<double> history; /**< residuals before every iteration */
    /** Its steps have taken the corrections of another orbit. */
    bool        is_held = false;
    HeldChanges left_open; /**< of one that is held */
  };

  struct ShootingSettings
  {
    unsigned int n_steps    = 128;
    unsigned int iterations = 30;
    double       tolerance  = 1e-6;
    /** The start is that of a motion whose changes of status were held. */
    bool holds_at_once = false;
    /** A motion whose held changes leave a larger residual open is none of the
     * model and has not converged. */
    double largest_left_open = 1e-2;
  };

  /**
   * Periodic motions by shooting: the unknowns are the state at the start and
   * the period T, the equations that it is there again after n equal steps of
   * T/n, and that it does not move along the motion (phase condition,
   * orthogonal to the velocity at the start). Newton's method with the exact
   * derivative of the steps; step lengths are halved where the residual does
   * not fall.
   *
   * The residual is what the state misses in the norm of its energy,
   * sqrt(|dv|^2 + |omega dq|^2 + dlambda G dlambda), over the largest such norm
   * of the motion about its mean.
   */
  PeriodicMotion shoot(const PeriodMap        &map,
                       const MotionState      &start,
                       const double            period,
                       const ShootingSettings &settings);

  /** The norm of the energy of a difference of two states. */
  double energy_norm(const ReducedContactModel &model,
                     const MotionState         &a,
                     const MotionState         &b);

  /** A motion that comes back no nearer, over the mean distance of
   * recurrences(), has no period. */
  constexpr double farthest_return = 0.3;

  /**
   * The times after which the end of @p orbit was before where it is, of those
   * between the times @p shortest and @p longest, and how near, over the mean
   * distance: the shortest of the minima of the distance that are below a tenth
   * of it, and the shortest of those no more than half above the least one, if
   * that is another. None where there is no minimum.
   */
  std::vector<std::pair<double, double>> recurrences(
    const ReducedContactModel &model,
    const Orbit               &orbit,
    const double               shortest,
    const double               longest);

  /** Stability of a periodic motion. */
  struct FloquetMultipliers
  {
    /** Descending in size; of a periodic motion one is 1. */
    Eigen::VectorXcd values;
    /** The one that belongs to a shift along the motion: its eigenvector has
     * the largest share of the direction of that. Another one may be as near
     * to 1. */
    std::complex<double> trivial;
    /** Of the others, in size. */
    double largest = 0.;

    /** The first of the largest in size without the trivial one; 1 if there is
     * no other. */
    std::complex<double> outermost() const;

    /** What the largest is uncertain by: its difference to half the steps. */
    double error = 0.;

    /** The larger of that and of what the trivial one misses 1 by: a derivative
     * that does not know the motion along the cycle better than this cannot be
     * trusted further elsewhere. */
    double uncertainty() const;
    /** By more than the uncertainty. */
    bool is_stable() const;
    bool is_unstable() const;
    /** "stable", "unstable", "at its limit" where they are too near to 1 to
     * tell. */
    std::string stability() const;
  };

  /** Eigenvalues of the derivative of the steps over the period. */
  FloquetMultipliers floquet_multipliers(const PeriodMap      &map,
                                         const PeriodicMotion &motion);
} // namespace squeal

#endif
