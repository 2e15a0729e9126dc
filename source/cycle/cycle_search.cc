// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/number_text.h>
#include <squeal/base/unknown_choice.h>
#include <squeal/cycle/cycle_search.h>
#include <squeal/transient/modal_step.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <tuple>

namespace squeal
{
  namespace
  {
    /** Largest velocity of a node, over the sliding speed, of the small motion
     * that amplitudes are scaled up from. */
    constexpr double small_motion = 1e-4;
    /** Part of the run in which the period is looked for, and how much of the
     * pair's period it is at least. */
    constexpr double share_of_run = 1. / 3., shortest_period = .45;

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

    /** Throws InputError naming @p entry, whose value is @p n steps of a period,
     * where they are too long. */
    void
    require_stable(const ReducedContactModel &model,
                   const double               period,
                   const unsigned int         n,
                   const double               steps_per_entry,
                   const std::string         &entry)
    {
      const double step    = period / n,
                   largest = largest_stable_step(model, step);
      if (largest >= step)
        return;
      const double fewest = std::ceil(steps_per_entry * period / largest);
      throw InputError(
        "Limit cycle/" + entry + ": steps of " + rounded_text(step, 3) +
        " s are above the largest stable one, " + rounded_text(largest, 3) +
        " s; at least " + rounded_text(fewest, 6) + " are needed");
    }

    /** |a_k| of x = mean + Re sum a_k e^{i k omega t}. */
    std::vector<double>
    amplitudes_of(const Eigen::VectorXd &x)
    {
      const Eigen::Index  n = x.size();
      std::vector<double> result;
      for (Eigen::Index k = 1; 2 * k < n; ++k)
        {
          std::complex<double> sum = 0.;
          for (Eigen::Index i = 0; i < n; ++i)
            sum +=
              x[i] * std::polar(2. / n, -2. * M_PI * double(k * i % n) / n);
          result.push_back(std::abs(sum));
        }
      return result;
    }

    /** Depth of the nodes in the middle of the steps, over all. */
    double
    penetration_of(const ReducedContactModel &model, const Orbit &orbit)
    {
      const ModalStep half(model, .5 * orbit.step);
      double          result = 0.;
      for (unsigned int i = 0; i < orbit.n_steps(); ++i)
        {
          const MotionState    &a = orbit.states[i], &b = orbit.states[i + 1];
          const Eigen::VectorXd lambda = .5 * (a.forces + b.forces);
          const auto            modal  = [&](const Eigen::VectorXd &f) {
            return Eigen::VectorXd(model.load -
                                   model.participation.transpose() * f);
          };
          const Eigen::VectorXd q = half.q_q.cwiseProduct(a.coordinates) +
                                    half.q_v.cwiseProduct(a.velocities) +
                                    half.q_f0.cwiseProduct(modal(a.forces)) +
                                    half.q_f1.cwiseProduct(modal(lambda));
          const Eigen::VectorXd u = model.participation * q +
                                    model.load_motion -
                                    model.flexibility * lambda;
          for (unsigned int j = 0; j < model.n_nodes(); ++j)
            result = std::max(result, u[3 * j] - model.initial_gap[j]);
        }
      return result;
    }
  } // namespace



  double
  CycleFigures::beyond(const unsigned int n) const
  {
    double sum = 0.;
    for (std::size_t k = n; k < normal_harmonics.size(); ++k)
      sum += .5 * normal_harmonics[k] * normal_harmonics[k];
    return std::sqrt(sum) / rms_normal;
  }

  CycleFigures
  cycle_figures(const PeriodMap &map, const PeriodicMotion &motion)
  {
    const ReducedContactModel &model = map.reduced_model();
    const Orbit               &orbit = motion.orbit;
    const unsigned int         n     = orbit.n_steps();
    CycleFigures               f;
    f.frequency  = 1. / motion.period;
    f.resultants = Eigen::MatrixXd::Zero(3, n);
    std::vector<bool> opens(model.n_nodes()), sticks(model.n_nodes());
    Eigen::VectorXd   lowest = orbit.motions[1], highest = lowest;
    for (unsigned int i = 0; i < n; ++i)
      {
        for (unsigned int j = 0; j < model.n_nodes(); ++j)
          {
            f.resultants.col(i) += orbit.states[i + 1].forces.segment<3>(3 * j);
            opens[j]  = opens[j] || orbit.status[i][j] == ContactStatus::open;
            sticks[j] = sticks[j] || orbit.status[i][j] == ContactStatus::stick;
          }
        lowest  = lowest.cwiseMin(orbit.motions[i + 1]);
        highest = highest.cwiseMax(orbit.motions[i + 1]);
      }
    for (unsigned int j = 0; j < model.n_nodes(); ++j)
      f.gap_range = std::max(f.gap_range, highest[3 * j] - lowest[3 * j]);
    const auto rms = [](const Eigen::VectorXd &x) {
      return std::sqrt((x.array() - x.mean()).square().mean());
    };
    const Eigen::VectorXd normal = f.resultants.row(0),
                          along  = f.resultants.row(1);
    f.mean_normal                = normal.mean();
    f.rms_normal                 = rms(normal);
    f.min_normal                 = normal.minCoeff();
    f.max_normal                 = normal.maxCoeff();
    f.mean_tangential            = along.mean();
    f.rms_tangential             = rms(along);
    f.normal_harmonics           = amplitudes_of(normal);
    f.tangential_harmonics       = amplitudes_of(along);
    f.largest_harmonic =
      1 + std::distance(f.normal_harmonics.begin(),
                        std::max_element(f.normal_harmonics.begin(),
                                         f.normal_harmonics.end()));
    f.penetration = penetration_of(model, orbit);
    f.n_opening   = std::count(opens.begin(), opens.end(), true);
    f.n_sticking  = std::count(sticks.begin(), sticks.end(), true);
    return f;
  }



  std::string
  CycleResult::status() const
  {
    const CycleStatus worst =
      coarse.status == CycleStatus::converged ? motion.status : coarse.status;
    switch (worst)
      {
      case CycleStatus::converged:
        return "periodic";
      case CycleStatus::not_converged:
        return "not converged";
      case CycleStatus::steady_sliding:
        return "steady sliding";
      case CycleStatus::no_period:
        return "no period";
      }
    unknown_choice("status of a cycle");
  }



  std::vector<double>
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
    const double speed        = std::abs(map.sliding_speed()),
                 small        = small_motion * speed / fastest;
    const Orbit         orbit = map.run(state_of_pair(steady, linear, k, small),
                                2. * M_PI / linear.lambda[k].imag(),
                                n_steps);
    std::vector<double> result;
    for (unsigned int j = 0; j < model.n_nodes(); ++j)
      if (steady.status[j] != ContactStatus::open && steady.forces[3 * j] > 0.)
        {
          double share = 0.;
          for (const MotionState &state : orbit.states)
            share =
              std::max(share, 1. - state.forces[3 * j] / steady.forces[3 * j]);
          const double way = orbit.step * speed * model.speed_ratio[j];
          // In the first step the forces leave those of steady sliding.
          for (unsigned int i = 1; i < orbit.n_steps() && way > 0.; ++i)
            {
              const Eigen::Vector3d moved =
                (orbit.motions[i + 1] - orbit.motions[i]).segment<3>(3 * j);
              share = std::max(share,
                               1. - std::hypot(way + moved[1], moved[2]) / way);
            }
          if (share > 0.)
            result.push_back(small / share);
        }
    std::sort(result.begin(), result.end());
    return result;
  }



  CycleResult
  find_cycle(const PeriodMap            &map,
             const SteadySliding        &steady,
             const LinearizedMotion     &linear,
             const Eigen::Index          k,
             const LimitCycleParameters &settings)
  {
    CycleResult  result;
    const double period = 2. * M_PI / linear.lambda[k].imag();
    result.pair         = linear.lambda[k];
    require_stable(map.reduced_model(),
                   period,
                   settings.run_steps,
                   1.,
                   "Run steps per period");
    const std::vector<double> changes =
      change_amplitudes(map, steady, linear, k, settings.run_steps);
    if (changes.empty())
      throw ComputationError("no node is closed in steady sliding");
    result.first_change = changes.front();
    result.half_change  = changes[changes.size() / 2];
    MotionState start =
      state_of_pair(steady, linear, k, settings.start * result.half_change);
    double guess = period;
    try
      {
        if (settings.run_time > 0.)
          {
            const double step = period / settings.run_steps;
            const auto   n    = static_cast<unsigned int>(
              std::max(2., std::ceil(settings.run_time / step)));
            const Orbit run = map.run(start, n * step, n);
            start           = run.end();
            std::tie(guess, result.recurrence) =
              recurrence(map.reduced_model(),
                         run,
                         shortest_period * period,
                         share_of_run * settings.run_time);
          }
      }
    catch (const ComputationError &)
      {
        guess = 0.;
      }
    if (!(guess > 0.))
      {
        result.coarse.status = CycleStatus::no_period;
        return result;
      }
    require_stable(
      map.reduced_model(), guess, settings.steps / 2, 2., "Steps per period");
    ShootingSettings shooting{
      settings.steps / 2, settings.iterations, settings.tolerance};
    result.coarse = shoot(map, start, guess, shooting);
    if (result.coarse.status != CycleStatus::converged)
      return result;
    shooting.n_steps = settings.steps;
    result.motion    = shoot(
      map, result.coarse.orbit.states.front(), result.coarse.period, shooting);
    if (result.motion.status != CycleStatus::converged)
      return result;
    result.coarse_figures = cycle_figures(map, result.coarse);
    result.figures        = cycle_figures(map, result.motion);
    result.multipliers    = floquet_multipliers(map, result.motion);
    result.multipliers.error =
      std::abs(result.multipliers.largest -
               floquet_multipliers(map, result.coarse).largest);
    return result;
  }
} // namespace squeal
