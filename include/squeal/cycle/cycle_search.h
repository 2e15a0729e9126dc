// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_cycle_cycle_search_h
#define squeal_cycle_cycle_search_h

#include <squeal/cycle/cycle_figures.h>
#include <squeal/cycle/leading_run.h>
#include <squeal/cycle/shooting.h>
#include <squeal/parameters/limit_cycle_parameters.h>
#include <squeal/transient/linearized_motion.h>

#include <string>

namespace squeal
{
  /** Error of a number that is @p with_all steps, and @p with_half of them: twice
   * the difference. Where forces jump, what a step misses hangs on where in it
   * the jump lies, and the difference of two numbers of steps is small by
   * chance as often as not (doc/theory/limit_cycles.md). */
  double error_by_steps(const double with_all, const double with_half);

  /** "1096.956 +- 0.00044": of @p value as many digits as its @p error leaves.
   */
  std::string with_error(const double value, const double error);

  /** Of one growing pair: the periodic motion that it leads to. */
  struct CycleResult
  {
    std::complex<double> pair; /**< 1/s */
    /** Of the start: kinetic amplitude as in LinearizedMotion, sqrt(J), at
     * which the first closed node opens or sticks, and half of those of the
     * pair of contacts that vibrates most: others may stay quiet. */
    double      first_change = 0., half_change = 0.;
    double      recurrence = 1.; /**< of the run before, see there */
    RunFigures  run;             /**< what that has come to */
    MotionPlace run_end;         /**< and where */
    /** s, in which the slowest pair of steady sliding that decays falls to less
     * than a hundredth: what a shorter run comes to may still settle. 0: no
     * pair decays. */
    double             settling_time = 0.;
    PeriodicMotion     coarse, motion; /**< with half the steps, with all */
    CycleFigures       coarse_figures, figures;
    FloquetMultipliers multipliers;
    /** Why the search has ended before anything was found; else empty. */
    std::string broken_off;

    bool
    has_converged() const
    {
      return motion.status == CycleStatus::converged &&
             coarse.status == CycleStatus::converged;
    }
    /** What the search has ended with, and that in words. */
    CycleStatus found() const;
    std::string status() const;
    /** Whether nothing was found though the forces of the run last: it may
     * have been on its way to a periodic motion. */
    bool may_settle() const;

    /** @name By the steps, see error_by_steps(). */
    //@{
    /** Hz; not smaller than what a start by a step later would change: that
     * misses itself after a period by what the trivial multiplier misses 1 by.
     */
    double frequency_error() const;
    /** N: of the difference of the harmonics that both numbers of steps have,
     * which is not smaller than that of the rms: harmonics that grow and others
     * that fall with the steps leave an rms that hardly changes by chance. */
    double rms_normal_error() const;
    /** N: of @p number of the normal force, of the rms that of the force which
     * is judged. */
    double force_error(double ForceFigures::*number) const;
    //@}

  private:
    /** Of half the steps, the forces of the pair that `figures` have. */
    const ForceFigures &coarse_forces() const;
  };

  /** Steady sliding and pair @p k of @p linear beside it, at @p amplitude,
   * sqrt(J), and phase 0, with the contact forces of steady sliding. */
  MotionState state_of_pair(const SteadySliding    &steady,
                            const LinearizedMotion &linear,
                            const Eigen::Index      k,
                            const double            amplitude);

  /** Amplitudes of pair @p k of @p linear, sqrt(J), at which the closed nodes one
   * after the other open or stick if the motion stays linear, ascending, of
   * every pair of contacts of @p map: a period of @p n_steps exact steps at a
   * small amplitude is scaled up. Empty where no node of a pair of contacts
   * moves. */
  std::vector<std::vector<double>> change_amplitudes(
    const PeriodMap        &map,
    const SteadySliding    &steady,
    const LinearizedMotion &linear,
    const Eigen::Index      k,
    const unsigned int      n_steps);

  /** Amplitudes at which a motion of pair @p k would leave the linear one,
   * sqrt(J): the first closed node opens or sticks, and half of those of the
   * pair of contacts that does so first. A pair of contacts that does not take
   * part in the motion has shares of rounding size. */
  struct StartAmplitudes
  {
    double first_change = 0., half_change = 0.;
  };

  /** Of change_amplitudes() over a period of at least @p run_steps steps. Throws
   * ComputationError where no node moves. */
  StartAmplitudes start_amplitudes(const PeriodMap        &map,
                                   const SteadySliding    &steady,
                                   const LinearizedMotion &linear,
                                   const Eigen::Index      k,
                                   const unsigned int      run_steps);

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
   * Where the contact of the small motion at its start or of the run has no
   * solution before anything was found, as where another motion of the model
   * grows so fast that it takes over, the search is broken off and has not
   * converged.
   */
  CycleResult find_cycle(const PeriodMap            &map,
                         const SteadySliding        &steady,
                         const LinearizedMotion     &linear,
                         const Eigen::Index          k,
                         const LimitCycleParameters &settings);
} // namespace squeal

#endif
