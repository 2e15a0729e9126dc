// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_cycle_cycle_search_h
#define squeal_cycle_cycle_search_h

#include <squeal/cycle/leading_run.h>
#include <squeal/cycle/shooting.h>
#include <squeal/parameters/limit_cycle_parameters.h>
#include <squeal/transient/linearized_motion.h>

#include <string>

namespace squeal
{
  /** Resultants of a periodic motion and what they are worth. */
  struct CycleFigures
  {
    double          frequency = 0.; /**< Hz */
    Eigen::MatrixXd resultants; /**< sums of the nodal forces, N: normal, along
                                   and across the sliding, x steps */
    double mean_normal = 0., rms_normal = 0., min_normal = 0., max_normal = 0.;
    double mean_tangential = 0., rms_tangential = 0.;
    /** Of the normal and the tangential resultant, N: x = Re sum a_k e^{i k
     * omega t}, k from 1 to half the steps. */
    std::vector<double> normal_harmonics, tangential_harmonics;
    unsigned int        largest_harmonic = 0; /**< of the normal resultant */
    /** Depth, m, that a node reaches in the middle of a step, and the largest
     * change of a gap over the period. */
    double       penetration = 0., gap_range = 0.;
    unsigned int n_opening = 0, n_sticking = 0; /**< nodes that do so */
    /** Root of the power of the normal resultant beyond @p n harmonics, over
     * its rms. */
    double beyond(const unsigned int n) const;
    /** How many times the shortest period of the resultants the period is: no
     * other harmonics but multiples of that have more than a thousandth of the
     * rms. */
    unsigned int repetitions() const;
  };

  CycleFigures cycle_figures(const PeriodMap      &map,
                             const PeriodicMotion &motion);

  /** Of one growing pair: the periodic motion that it leads to. */
  struct CycleResult
  {
    std::complex<double> pair; /**< 1/s */
    /** Of the start: kinetic amplitude as in LinearizedMotion, sqrt(J), at
     * which the first closed node opens or sticks, and half of them. */
    double             first_change = 0., half_change = 0.;
    double             recurrence = 1.; /**< of the run before, see there */
    RunFigures         run;             /**< what that has come to */
    MotionPlace        run_end;         /**< and where */
    PeriodicMotion     coarse, motion;  /**< with half the steps, with all */
    CycleFigures       coarse_figures, figures;
    FloquetMultipliers multipliers;

    bool
    has_converged() const
    {
      return motion.status == CycleStatus::converged &&
             coarse.status == CycleStatus::converged;
    }
    std::string status() const;

    /** @name By the steps: twice the difference to half of them. Where forces
     * jump, what a step misses hangs on where in it the jump lies, and the
     * difference of two numbers of steps is small by chance as often as not
     * (doc/theory/limit_cycles.md). */
    //@{
    double frequency_error() const;  /**< Hz */
    double rms_normal_error() const; /**< N */
    //@}
  };

  /** Amplitudes of pair @p k, sqrt(J), at which the closed nodes one after the
   * other open or stick if the motion stays linear, ascending: a period of the
   * exact steps at a small amplitude is scaled up. */
  std::vector<double> change_amplitudes(const PeriodMap        &map,
                                        const SteadySliding    &steady,
                                        const LinearizedMotion &linear,
                                        const Eigen::Index      k,
                                        const unsigned int      n_steps);

  /**
   * The periodic motion near @p start, by shooting with half the steps of @p
   * settings and with all of them: the first that converges from the guesses @p
   * periods, s, ascending; those that are multiples of the first have as many
   * times the steps. `no_period` without guesses. The members about a pair are
   * empty.
   */
  CycleResult find_cycle_near(const PeriodMap            &map,
                              const MotionState          &start,
                              const std::vector<double>  &periods,
                              const LimitCycleParameters &settings);

  /**
   * From steady sliding with pair @p k at an amplitude, over a run, to the
   * periodic motion, by shooting with half the steps and with all of them as
   * soon as the run has settled. From an unstable cycle the run goes on, and
   * what it comes to later takes the place of that cycle if it is not unstable.
   */
  CycleResult find_cycle(const PeriodMap            &map,
                         const SteadySliding        &steady,
                         const LinearizedMotion     &linear,
                         const Eigen::Index          k,
                         const LimitCycleParameters &settings);
} // namespace squeal

#endif
