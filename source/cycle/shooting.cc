// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/cycle/period_equations.h>
#include <squeal/cycle/shooting.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>

namespace squeal
{
  namespace
  {
    /** The period changes by no more than this share in an iteration. */
    constexpr double largest_change = 0.1;
    /** Residual below which located changes are held where an iteration gains
     * less than the share below: the steps jump a little where a change of one
     * node disturbs what is told from the steps before another one. */
    constexpr double hold_below = 1e-2, least_gain = 0.3;
    /** Shortest step of Newton's method over its full one. */
    constexpr double shortest_step = 1. / 64.;

    /** The best orbit along Newton's step @p change; @p full_only: its end
     * alone. The residual is the largest number where there is none. */
    PeriodicMotion
    search_along(const PeriodMap        &map,
                 const PeriodicMotion   &m,
                 const ScaledMotion     &scaled,
                 const Eigen::VectorXd  &change,
                 const ShootingSettings &settings,
                 const StepCorrections  *held,
                 const bool              full_only)
    {
      // In a periodic motion the start's past is that of the end.
      const ContactPast  past = m.orbit.past_of(settings.n_steps);
      const Eigen::Index n    = change.size() - 1;
      PeriodicMotion     best;
      best.residual = std::numeric_limits<double>::max();
      for (double step = std::min(1., largest_change / std::abs(change[n]));
           step >= shortest_step;
           step *= .5)
        {
          PeriodicMotion next;
          if (try_orbit(
                map,
                scaled.moved(m.orbit.states.front(), step * change.head(n)),
                m.period * (1. + step * change[n]),
                settings.n_steps,
                past,
                held,
                next) &&
              next.residual < best.residual)
            best = std::move(next);
          if (full_only || best.residual < (1. - .2 * step) * m.residual)
            break;
        }
      return best;
    }
  } // namespace



  std::pair<double, double>
  recurrence(const ReducedContactModel &model,
             const Orbit               &orbit,
             const double               shortest,
             const double               longest)
  {
    const auto          n = static_cast<std::size_t>(orbit.n_steps());
    std::vector<double> distance{0.};
    double              mean = 0., least = std::numeric_limits<double>::max();
    for (std::size_t k = 1; k <= n && k * orbit.step <= longest; ++k)
      {
        distance.push_back(
          energy_norm(model, orbit.end(), orbit.states[n - k]));
        mean += distance.back();
      }
    mean /= std::max<std::size_t>(distance.size() - 1, 1);
    const auto is_minimum = [&](const std::size_t k) {
      return k * orbit.step >= shortest && distance[k] <= distance[k - 1] &&
             distance[k] <= distance[k + 1];
    };
    for (std::size_t k = 1; k + 1 < distance.size(); ++k)
      if (is_minimum(k))
        least = std::min(least, distance[k]);
    for (std::size_t k = 1; k + 1 < distance.size(); ++k)
      if (is_minimum(k) && distance[k] <= 1.5 * least)
        {
          const auto square = [&](const std::size_t i) {
            return distance[i] * distance[i];
          };
          const double curvature =
            square(k - 1) - 2. * square(k) + square(k + 1);
          const double shift =
            curvature > 0. ? .5 * (square(k - 1) - square(k + 1)) / curvature
                           : 0.;
          return {(k + shift) * orbit.step, distance[k] / mean};
        }
    return {0., 1.};
  }



  PeriodicMotion
  shoot(const PeriodMap        &map,
        const MotionState      &start,
        const double            period,
        const ShootingSettings &settings)
  {
    PeriodicMotion m;
    if (!try_orbit(map, start, period, settings.n_steps, {}, nullptr, m))
      return m;
    StepCorrections held;
    bool            is_held = false;
    for (;; ++m.iterations)
      {
        m.history.push_back(m.residual);
        if (is_steady(map, m.orbit))
          {
            m.status = CycleStatus::steady_sliding;
            return m;
          }
        if (m.residual <= settings.tolerance && m.orbit.past.is_known())
          {
            m.status = CycleStatus::converged;
            return m;
          }
        if (m.iterations >= settings.iterations)
          return m;
        const std::vector<int> rows = map.closed_rows(m.orbit);
        const ScaledMotion     scaled(map.reduced_model(), rows, m.period);
        const PeriodEquations  equations(map,
                                        m,
                                        scaled,
                                        rows,
                                        is_held ? StatusChanges::held
                                                 : StatusChanges::located);
        const Eigen::VectorXd  change = equations.solve();
        if (!change.allFinite())
          return m;
        const bool     may_hold     = !is_held && m.residual < hold_below;
        PeriodicMotion best         = search_along(map,
                                           m,
                                           scaled,
                                           change,
                                           settings,
                                           is_held ? &held : nullptr,
                                           may_hold);
        const bool     has_improved = best.residual < m.residual;
        if (may_hold && !(best.residual < least_gain * m.residual))
          {
            held    = (has_improved ? best : m).orbit.corrections;
            is_held = true;
          }
        else if (!has_improved)
          return m;
        if (has_improved)
          {
            m.orbit    = std::move(best.orbit);
            m.period   = best.period;
            m.residual = best.residual;
            m.is_held  = best.is_held;
          }
      }
  }



  bool
  FloquetMultipliers::is_stable() const
  {
    return largest + uncertainty() < 1.;
  }

  bool
  FloquetMultipliers::is_unstable() const
  {
    return largest - uncertainty() > 1.;
  }

  std::string
  FloquetMultipliers::stability() const
  {
    return is_stable() ? "stable" : is_unstable() ? "unstable" : "at its limit";
  }

  double
  FloquetMultipliers::uncertainty() const
  {
    return std::max(error, std::abs(trivial - 1.));
  }

  FloquetMultipliers
  floquet_multipliers(const PeriodMap &map, const PeriodicMotion &motion)
  {
    const std::vector<int> rows = map.closed_rows(motion.orbit);
    const ScaledMotion     scaled(map.reduced_model(), rows, motion.period);
    const Eigen::EigenSolver<Eigen::MatrixXd> solver(
      scaled.derivative(map.derivative(motion.orbit, rows)), false);
    if (solver.info() != Eigen::Success)
      throw ComputationError("the multipliers of a periodic motion do not "
                             "converge");
    FloquetMultipliers result;
    result.values = solver.eigenvalues();
    std::sort(
      result.values.begin(),
      result.values.end(),
      [](const auto a, const auto b) { return std::abs(a) > std::abs(b); });
    Eigen::Index at = 0;
    (result.values.array() - 1.).abs().minCoeff(&at);
    result.trivial = result.values[at];
    for (Eigen::Index k = 0; k < result.values.size(); ++k)
      if (k != at)
        result.largest = std::max(result.largest, std::abs(result.values[k]));
    return result;
  }
} // namespace squeal
