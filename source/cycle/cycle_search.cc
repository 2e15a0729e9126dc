// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/number_text.h>
#include <squeal/cycle/cycle_search.h>
#include <squeal/cycle/period_equations.h>
#include <squeal/transient/modal_step.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace squeal
{
  namespace
  {
    /** Largest velocity of a node, over the sliding speed, of the small motion
     * that amplitudes are scaled up from. */
    constexpr double small_motion = 1e-4;
    /** Parts of the run that leads to a cycle: so many at most, none shorter
     * than so many periods of the pair. A time shorter than this share of the
     * pair's period is no return. */
    constexpr double most_parts = 10., periods_of_part = 10.,
                     shortest_period = .45;
    /** Steps of a period of the pair in it, where more are asked for. */
    constexpr double least_run_steps = 24.;
    /** Steps of the one period in which amplitudes are scaled up, so that they
     * are good to some thousandths. */
    constexpr unsigned int amplitude_steps = 200;
    /** How often a periodic motion is sought along it: again where it comes
     * back nearer by this share than the time before. */
    constexpr unsigned int most_searches = 3;
    constexpr double       much_nearer   = 0.5;
    /** A motion that comes back nearer may have a period that was not found. */
    constexpr double may_have_period = 0.05;
    /** A force that repeats itself so well is that of a motion that settles. */
    constexpr double repeats_itself = 0.97;
    /** A disturbance that has decayed by the factor e as often as this is
     * gone. */
    constexpr double decays_of_settling = 5.;
    /** Room for that of the period while it is sought. */
    constexpr double growth_of_period = 1.1;
    /** What held changes of status may leave open of the motion by half of the
     * steps, which is the start of the one by all. */
    constexpr double largest_left_open_of_start = 0.1;
    /** @p n steps of @p period, or as many more as are stable when @p factor of
     * them are one. */
    unsigned int
    stable_steps(const ReducedContactModel &model,
                 const double               period,
                 const unsigned int         n,
                 const unsigned int         factor)
    {
      // The period may grow while it is sought.
      const double coarse  = growth_of_period * period * factor / n,
                   largest = largest_stable_step(model, coarse);
      return largest >= coarse
               ? n
               : factor * static_cast<unsigned int>(
                            std::ceil(growth_of_period * period / largest));
    }

    /** The state of the run of @p time from @p start in which the fewest nodes
     * touch, in the middle of that time: their forces are unknowns of the
     * periodic motion that starts there, and the derivative over the period has
     * three columns for each. The start itself where there is no such run. */
    MotionState
    with_fewest_closed(const PeriodMap   &map,
                       const MotionState &start,
                       const double       time,
                       const unsigned int n_steps)
    {
      PeriodicMotion tried;
      if (!try_orbit(map, start, time, n_steps, {}, nullptr, tried))
        return start;
      const Orbit &orbit    = tried.orbit;
      const auto   n_closed = [&](const unsigned int i) {
        const Eigen::VectorXd &forces = orbit.states[i].forces;
        unsigned int           result = 0;
        for (Eigen::Index j = 0; 3 * j < forces.size(); ++j)
          result += forces[3 * j] > 0.;
        return result;
      };
      unsigned int first = 0, last = 0, fewest = n_closed(0);
      for (unsigned int i = 1; i <= n_steps; ++i)
        {
          const unsigned int n = n_closed(i);
          if (n < fewest)
            {
              fewest = n;
              first = last = i;
            }
          else if (n == fewest && last + 1 == i)
            last = i;
        }
      return orbit.states[first == 0 ? 0 : (first + last) / 2];
    }

    /** The periodic motion near @p start by half of @p n_steps and by all of
     * them, with its figures. */
    void
    search_with(const PeriodMap            &map,
                const MotionState          &start,
                const double                guess,
                const unsigned int          n_steps,
                const LimitCycleParameters &settings,
                CycleResult                &result)
    {
      ShootingSettings shooting{
        n_steps / 2, settings.iterations, settings.tolerance};
      result.motion              = {};
      shooting.largest_left_open = largest_left_open_of_start;
      result.coarse              = shoot(map, start, guess, shooting);
      if (result.coarse.status != CycleStatus::converged)
        return;
      shooting.n_steps           = n_steps;
      shooting.holds_at_once     = result.coarse.is_held;
      shooting.largest_left_open = ShootingSettings().largest_left_open;
      result.motion              = shoot(map,
                            result.coarse.orbit.states.front(),
                            result.coarse.period,
                            shooting);
      if (result.motion.status != CycleStatus::converged)
        return;
      result.figures = cycle_figures(map, result.motion);
      result.coarse_figures =
        cycle_figures(map, result.coarse, &result.figures);
      result.multipliers = floquet_multipliers(map, result.motion);
      result.multipliers.error =
        std::abs(result.multipliers.largest -
                 floquet_multipliers(map, result.coarse).largest);
    }

    /** The periodic motion near @p start by the times of @p returns, in which
     * it comes back, and how near. Where @p must_be_stable a longer period is
     * tried as well where the motion of the shorter one is unstable. */
    CycleResult
    of_returns(const PeriodMap                              &map,
               const MotionState                            &start,
               const std::vector<std::pair<double, double>> &returns,
               const LimitCycleParameters                   &settings,
               CycleResult                                   result,
               const bool                                    must_be_stable)
    {
      result.coarse.status = CycleStatus::no_period;
      // Where the shorter period belongs to an unstable motion, the longer one
      // may be what it has doubled to.
      for (const auto &[guess, distance] : returns)
        {
          CycleResult  next = result;
          const double times =
            std::max(1., std::round(guess / returns[0].first));
          const auto n_steps =
            static_cast<unsigned int>(times) * settings.steps;
          next.recurrence = distance;
          const unsigned int n_stable =
            stable_steps(map.reduced_model(), guess, n_steps, 2);
          search_with(map,
                      must_be_stable
                        ? with_fewest_closed(map, start, guess, n_stable / 2)
                        : start,
                      guess,
                      n_stable,
                      settings,
                      next);
          const bool is_better =
            !result.has_converged() ||
            (next.has_converged() && next.multipliers.is_stable());
          if (is_better)
            result = std::move(next);
          if (result.has_converged() &&
              (!must_be_stable || !result.multipliers.is_unstable()))
            break;
        }
      return result;
    }

    /** Steps of a period of pair @p k in the run, s: what a fast pair leads to is
     * often the motion of the slowest one that grows. */
    double
    run_step(const ReducedContactModel  &model,
             const LinearizedMotion     &linear,
             const Eigen::Index          k,
             const LimitCycleParameters &settings)
    {
      double slowest = linear.lambda[k].imag();
      for (const std::complex<double> l : linear.lambda)
        if (l.real() > 0. && l.imag() > 0.)
          slowest = std::min(slowest, l.imag());
      const double period = 2. * M_PI / linear.lambda[k].imag(),
                   n = settings.run_steps * slowest / linear.lambda[k].imag();
      const auto n_steps = static_cast<unsigned int>(std::ceil(
        std::max(n, std::min<double>(settings.run_steps, least_run_steps))));
      return period / stable_steps(model, period, n_steps, 1);
    }

    /** Says why nothing was found. */
    void
    break_off(CycleResult &result, const ComputationError &why)
    {
      result.coarse.status = CycleStatus::not_converged;
      result.broken_off    = "the search for a limit cycle from the pair at " +
                          rounded_text(result.pair.imag() / (2. * M_PI), 6) +
                          " Hz has broken off: " + why.what();
    }

    /** See CycleResult::settling_time. */
    double
    settling_time_of(const LinearizedMotion &linear)
    {
      double result = 0.;
      for (const std::complex<double> l : linear.lambda)
        if (l.real() < 0. && l.imag() > 0.)
          result = std::max(result, -decays_of_settling / l.real());
      return result;
    }

    /** Whether the motion of @p run, in which nothing was found, is known to
     * last without a period: a disturbance of it grows, or it comes no nearer
     * although all that decays has had the time to. Else it may still settle,
     * which the forces of a short run do not tell. */
    bool
    is_aperiodic(const LeadingRun &run,
                 const RunFigures &figures,
                 const double      settling_time)
    {
      if (!figures.lasts || figures.recurrence <= may_have_period ||
          figures.repetition >= repeats_itself)
        return false;
      try
        {
          return run.disturbance_grows() ||
                 (figures.time >= settling_time && run.has_stopped_nearing());
        }
      catch (const ComputationError &)
        {
          return false;
        }
    }

    /** Seeks the periodic motion that @p run comes to. */
    CycleResult
    along(LeadingRun                 &run,
          const PeriodMap            &map,
          const LimitCycleParameters &settings,
          CycleResult                 start)
    {
      start.coarse.status     = CycleStatus::no_period;
      CycleResult  result     = start;
      unsigned int n_searches = 0;
      double       tried      = 2.; // nearest return of the last search
      try
        {
          for (bool goes_on = true; goes_on;)
            {
              goes_on           = run.advance();
              const bool   last = !goes_on && n_searches == 0;
              const double near = run.nearest_return();
              const bool   seeks =
                (run.has_settled() && near < much_nearer * tried) ||
                (last && near <= farthest_return);
              if (!run.has_settled())
                tried = 2.;
              if (!seeks || n_searches == most_searches)
                continue;
              tried = near;
              ++n_searches;
              CycleResult next = of_returns(
                map, run.end().state, run.returns(), settings, start, true);
              if (!result.has_converged() ||
                  (next.has_converged() && !next.multipliers.is_unstable()))
                result = std::move(next);
              if (result.has_converged() && !result.multipliers.is_unstable())
                break;
            }
        }
      catch (const ComputationError &e)
        {
          // What was found before still counts.
          if (!result.has_converged())
            break_off(result, e);
        }
      result.run     = run.figures();
      result.run_end = run.end();
      if (!result.has_converged() && result.broken_off.empty() &&
          is_aperiodic(run, result.run, result.settling_time))
        result.coarse.status = CycleStatus::aperiodic;
      return result;
    }

    /** How near node @p j comes to opening (1: it does) or to sticking in the
     * motion @p orbit, whose growth at the rate @p sigma, 1/s, is taken off: an
     * amplitude must not depend on the phase that the motion starts with. 0
     * where the node is open in steady sliding. */
    double
    nearness_to_change(const PeriodMap     &map,
                       const SteadySliding &steady,
                       const Orbit         &orbit,
                       const double         sigma,
                       const unsigned int   j)
    {
      const double pressing = steady.forces[3 * j];
      if (steady.status[j] == ContactStatus::open || !(pressing > 0.))
        return 0.;
      const auto without_growth = [&](const double share, const double step) {
        return share * std::exp(-sigma * step * orbit.step);
      };
      double share = 0.;
      for (unsigned int i = 0; i < orbit.states.size(); ++i)
        share = std::max(
          share,
          without_growth(1. - orbit.states[i].forces[3 * j] / pressing, i));
      const double way = orbit.step * std::abs(map.sliding_speed()) *
                         map.reduced_model().speed_ratio[j];
      // In the first step the forces leave those of steady sliding.
      for (unsigned int i = 1; i < orbit.n_steps() && way > 0.; ++i)
        {
          const Eigen::Vector3d moved =
            (orbit.motions[i + 1] - orbit.motions[i]).segment<3>(3 * j);
          share = std::max(
            share,
            without_growth(1. - std::hypot(way + moved[1], moved[2]) / way,
                           i + .5));
        }
      return share;
    }
  } // namespace



  MotionState
  state_of_pair(const SteadySliding    &steady,
                const LinearizedMotion &linear,
                const Eigen::Index      k,
                const double            amplitude)
  {
    const Eigen::Index    n = steady.coordinates.size();
    const Eigen::VectorXd x = amplitude * linear.right.col(k).real();
    return {steady.coordinates + x.head(n), x.segment(n, n), steady.forces};
  }



  std::vector<std::vector<double>>
  change_amplitudes(const PeriodMap        &map,
                    const SteadySliding    &steady,
                    const LinearizedMotion &linear,
                    const Eigen::Index      k,
                    const unsigned int      n_steps)
  {
    const ReducedContactModel &model = map.reduced_model();
    const Eigen::Index         n     = model.n_modes();
    const double               fastest =
      (model.participation * linear.right.col(k).segment(n, n))
        .cwiseAbs()
        .maxCoeff();
    const double small = small_motion * std::abs(map.sliding_speed()) / fastest;
    const Orbit  orbit = map.run(state_of_pair(steady, linear, k, small),
                                2. * M_PI / linear.lambda[k].imag(),
                                n_steps);
    std::vector<std::vector<double>> result;
    unsigned int                     first = 0;
    for (const unsigned int n_nodes : map.nodes_of_pairs())
      {
        std::vector<double> &of_pair = result.emplace_back();
        for (unsigned int j = first; j < first + n_nodes; ++j)
          if (const double share = nearness_to_change(
                map, steady, orbit, linear.lambda[k].real(), j);
              share > 0.)
            of_pair.push_back(small / share);
        std::sort(of_pair.begin(), of_pair.end());
        first += n_nodes;
      }
    return result;
  }



  StartAmplitudes
  start_amplitudes(const PeriodMap        &map,
                   const SteadySliding    &steady,
                   const LinearizedMotion &linear,
                   const Eigen::Index      k,
                   const unsigned int      run_steps)
  {
    const unsigned int n_steps =
      stable_steps(map.reduced_model(),
                   2. * M_PI / linear.lambda[k].imag(),
                   std::max(run_steps, amplitude_steps),
                   1);
    StartAmplitudes result;
    bool            is_there = false;
    for (const std::vector<double> &changes :
         change_amplitudes(map, steady, linear, k, n_steps))
      if (!changes.empty())
        {
          const double first = changes.front(),
                       half  = changes[changes.size() / 2];
          result.first_change =
            is_there ? std::min(result.first_change, first) : first;
          result.half_change =
            is_there ? std::min(result.half_change, half) : half;
          is_there = true;
        }
    if (!is_there)
      throw ComputationError("no node is closed in steady sliding");
    return result;
  }



  namespace
  {
    /** find_cycle(); throws ComputationError where that breaks off. */
    CycleResult
    cycle_from_pair(const PeriodMap            &map,
                    const SteadySliding        &steady,
                    const LinearizedMotion     &linear,
                    const Eigen::Index          k,
                    const LimitCycleParameters &settings)
    {
      CycleResult  result;
      const double period  = 2. * M_PI / linear.lambda[k].imag();
      result.pair          = linear.lambda[k];
      result.settling_time = settling_time_of(linear);
      const StartAmplitudes amplitudes =
        start_amplitudes(map, steady, linear, k, settings.run_steps);
      result.first_change = amplitudes.first_change;
      result.half_change  = amplitudes.half_change;
      MotionState start =
        state_of_pair(steady, linear, k, settings.start * result.half_change);
      if (!(settings.run_time > 0.))
        return of_returns(
          map, start, {{period, 1.}}, settings, std::move(result), true);
      const double part =
        std::max(periods_of_part * period, settings.run_time / most_parts);
      LeadingRun run(map,
                     {start, {}, 0.},
                     run_step(map.reduced_model(), linear, k, settings),
                     part,
                     settings.run_time,
                     shortest_period * period);
      return along(run, map, settings, std::move(result));
    }
  } // namespace

  CycleResult
  find_cycle(const PeriodMap            &map,
             const SteadySliding        &steady,
             const LinearizedMotion     &linear,
             const Eigen::Index          k,
             const LimitCycleParameters &settings)
  {
    try
      {
        return cycle_from_pair(map, steady, linear, k, settings);
      }
    catch (const ComputationError &e)
      {
        CycleResult result;
        result.pair = linear.lambda[k];
        break_off(result, e);
        return result;
      }
  }



  CycleResult
  find_cycle_near(const PeriodMap            &map,
                  const MotionState          &start,
                  const std::vector<double>  &periods,
                  const LimitCycleParameters &settings)
  {
    std::vector<std::pair<double, double>> guesses;
    for (const double period : periods)
      guesses.emplace_back(period, 1.);
    return of_returns(map, start, guesses, settings, {}, false);
  }
} // namespace squeal
