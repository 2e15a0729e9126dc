// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/cycle/period_equations.h>
#include <squeal/cycle/shooting.h>
#include <squeal/eigen/standard_pairs.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace squeal
{
  namespace
  {
    /** The period changes by no more than this share in an iteration. */
    constexpr double largest_period_change = 0.1;
    /** Shortest step of Newton's method over its full one. */
    constexpr double shortest_step = 1. / 64.;
    /** A motion that comes back as near as this, over the mean distance, may
     * have that time as its period although it comes nearer later. */
    constexpr double near_return = 0.1;
    /** The derivative of earlier iterations serves while one leaves no more
     * than this share of the residual: it takes as long as five periods. */
    constexpr double gain_of_chord = 0.2;

    /** The equations of a period as they were linearised last. */
    struct Linearised
    {
      Linearised(const PeriodMap        &map,
                 const PeriodicMotion   &m,
                 const std::vector<int> &r,
                 const StatusChanges     changes)
        : rows(r)
        , scaled(map.reduced_model(), rows, m.period)
        , equations(map, m, scaled, rows, changes)
      {
      }

      /** Newton's step or, of another motion than that of the equations, the
       * chord's. */
      Eigen::VectorXd
      step(const PeriodicMotion &m) const
      {
        return equations.solve(
          scaled.difference(m.orbit.end(), m.orbit.states.front()));
      }

      const std::vector<int> rows;
      const ScaledMotion     scaled;
      const PeriodEquations  equations;
    };

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
      for (double step =
             std::min(1., largest_period_change / std::abs(change[n]));
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
                next,
                &m.orbit) &&
              next.residual < best.residual)
            best = std::move(next);
          if (full_only || best.residual < (1. - .2 * step) * m.residual)
            break;
        }
      return best;
    }
  } // namespace



  std::vector<std::pair<double, double>>
  recurrences(const ReducedContactModel &model,
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
    std::vector<std::size_t> minima;
    for (std::size_t k = 1; k + 1 < distance.size(); ++k)
      if (k * orbit.step >= shortest && distance[k] <= distance[k - 1] &&
          distance[k] <= distance[k + 1])
        {
          minima.push_back(k);
          least = std::min(least, distance[k]);
        }
    const auto time_of = [&](const std::size_t k) {
      const auto square = [&](const std::size_t i) {
        return distance[i] * distance[i];
      };
      const double curvature = square(k - 1) - 2. * square(k) + square(k + 1);
      const double shift =
        curvature > 0. ? .5 * (square(k - 1) - square(k + 1)) / curvature : 0.;
      return (k + shift) * orbit.step;
    };
    std::vector<std::pair<double, double>> result;
    for (const double bound : {near_return * mean, 1.5 * least})
      {
        const auto k =
          std::find_if(minima.begin(), minima.end(), [&](const std::size_t i) {
            return distance[i] <= std::max(bound, 1.5 * least);
          });
        if (k != minima.end() &&
            (result.empty() || time_of(*k) > result.back().first))
          result.emplace_back(time_of(*k), distance[*k] / mean);
      }
    return result;
  }



  namespace
  {
    /** The iterations of shoot(). */
    class Shooting
    {
    public:
      Shooting(const PeriodMap &m, const ShootingSettings &s, PeriodicMotion x)
        : map(m)
        , settings(s)
        , motion(std::move(x))
      {
        if (settings.holds_at_once)
          hold();
      }

      PeriodicMotion
      iterate()
      {
        for (;; ++motion.iterations)
          {
            motion.history.push_back(motion.residual);
            if (is_steady(map, motion.orbit))
              motion.status = CycleStatus::steady_sliding;
            else if (is_there() && !has_located_anew())
              {
                run_alone();
                if (is_held())
                  motion.left_open = what_is_left_open();
                if (motion.left_open.residual < settings.largest_left_open)
                  motion.status = CycleStatus::converged;
                return motion;
              }
            if (motion.status != CycleStatus::not_converged ||
                motion.iterations >= settings.iterations || !improve())
              break;
          }
        if (is_held() && motion.status == CycleStatus::not_converged)
          if (const auto located = located_anew(map, motion))
            motion.left_open.residual = located->residual;
        return motion;
      }

    private:
      using Rule = StatusChangeRule;

      bool
      is_there() const
      {
        return motion.residual <= settings.tolerance &&
               motion.orbit.past.is_known();
      }

      /** A better motion; false where none is found. */
      bool
      improve()
      {
        const std::vector<int> rows      = map.closed_rows(motion.orbit);
        const bool             is_newton = !linear || linear->rows != rows;
        if (is_newton)
          linear.emplace(map,
                         motion,
                         rows,
                         is_held() ? StatusChanges::held
                                   : StatusChanges::located);
        const Eigen::VectorXd change = linear->step(motion);
        if (!change.allFinite())
          return false;
        const double   residual = motion.residual;
        const bool     is_near  = !is_held() && residual < Rule::near_enough;
        PeriodicMotion best     = search_along(map,
                                           motion,
                                           linear->scaled,
                                           change,
                                           settings,
                                           is_held() ? &*held : nullptr,
                                           is_near || !is_newton);
        const double   gain     = best.residual / residual;
        if (gain < 1.)
          take(best);
        if (!(gain < gain_of_chord))
          linear.reset();
        const bool will_hold =
          !is_held() && is_newton && Rule::holds(residual, gain);
        if (will_hold)
          hold();
        return gain < 1. || !is_newton || will_hold;
      }

      void
      take(PeriodicMotion &next)
      {
        motion.orbit    = std::move(next.orbit);
        motion.period   = next.period;
        motion.residual = next.residual;
        motion.is_held  = next.is_held;
      }

      /** Runs the motion again without those that have led to it, so that its
       * bits depend on its start alone: what is stored comes back the same. */
      void
      run_alone()
      {
        PeriodicMotion alone;
        if (try_orbit(map,
                      motion.orbit.states.front(),
                      motion.period,
                      settings.n_steps,
                      motion.orbit.past,
                      is_held() ? &*held : nullptr,
                      alone))
          take(alone);
      }

      bool
      is_held() const
      {
        return held.has_value();
      }

      void
      hold()
      {
        held    = motion.orbit.corrections;
        held_at = motion.residual;
        linear.reset();
      }

      /** Whether changes that were held from far away can be located on the
       * motion that has been found, so that it moves on to one of its own.
       * Those of a motion far away make another one periodic, however short the
       * steps: where what is located comes much nearer than they were they are
       * held again as they lie there. Where the steps are too rough the
       * residual is as large again. */
      bool
      has_located_anew()
      {
        if (!is_held() || held_at < Rule::near_enough)
          return false;
        const double before  = std::exchange(held_at, 0.);
        auto         located = located_anew(map, motion);
        if (!located || !(located->residual < Rule::near_enough ||
                          located->residual < Rule::much_nearer * before))
          return false;
        take(*located);
        if (motion.residual < Rule::near_enough)
          {
            held.reset();
            linear.reset();
          }
        else
          hold();
        return true;
      }

      /** Of the motion, which is periodic as it is held. */
      HeldChanges
      what_is_left_open()
      {
        HeldChanges result;
        const auto  located = located_anew(map, motion);
        if (!located)
          {
            result.residual = std::numeric_limits<double>::infinity();
            return result;
          }
        result.residual = located->residual;
        if (const std::vector<int> rows = map.closed_rows(motion.orbit);
            !linear || linear->rows != rows)
          linear.emplace(map, motion, rows, StatusChanges::held);
        const Eigen::VectorXd change = linear->step(*located);
        const Eigen::Index    n      = change.size() - 1;
        result.period                = std::abs(change[n]);
        result.motion                = change.head(n).norm() /
                        motion_size(map.reduced_model(), motion.orbit);
        return result;
      }

      const PeriodMap               &map;
      const ShootingSettings        &settings;
      PeriodicMotion                 motion;
      std::optional<Linearised>      linear;
      std::optional<StepCorrections> held;
      double                         held_at = 0.; /**< residual */
    };
  } // namespace



  PeriodicMotion
  shoot(const PeriodMap        &map,
        const MotionState      &start,
        const double            period,
        const ShootingSettings &settings)
  {
    PeriodicMotion m;
    if (!try_orbit(map, start, period, settings.n_steps, {}, nullptr, m))
      return m;
    return Shooting(map, settings, std::move(m)).iterate();
  }



  std::complex<double>
  FloquetMultipliers::outermost() const
  {
    for (const std::complex<double> m : values)
      if (m != trivial)
        return m;
    return 1.;
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

  namespace
  {
    /** Multipliers below this are none of a motion along the cycle. */
    constexpr double least_of_trivial = 0.3;

    /** The eigenvector that has the largest share of @p direction written as a
     * sum of them, of those of multipliers that are not below
     * least_of_trivial. */
    Eigen::Index
    largest_share(const StandardPairs &pairs, const Eigen::VectorXd &direction)
    {
      const Eigen::VectorXcd d      = direction.cast<std::complex<double>>();
      double                 most   = -1.;
      Eigen::Index           result = -1;
      for (Eigen::Index k = 0; k < pairs.values.size(); ++k)
        {
          const auto   left = pairs.left.col(k).transpose();
          const double share =
            std::abs((left * d)[0] / (left * pairs.right.col(k))[0]);
          if (std::abs(pairs.values[k]) > least_of_trivial && share > most)
            {
              most   = share;
              result = k;
            }
        }
      if (result < 0)
        throw ComputationError("a periodic motion has no multiplier near 1");
      return result;
    }
  } // namespace

  FloquetMultipliers
  floquet_multipliers(const PeriodMap &map, const PeriodicMotion &motion)
  {
    const std::vector<int> rows = map.closed_rows(motion.orbit);
    const ScaledMotion     scaled(map.reduced_model(), rows, motion.period);
    const StandardPairs    pairs =
      standard_pairs(scaled.derivative(map.derivative(motion.orbit, rows)));
    const MotionState  rate = rate_of_motion(map, motion.orbit);
    FloquetMultipliers result;
    result.values  = pairs.values;
    result.trivial = result.values[largest_share(
      pairs, scaled.pack(rate.coordinates, rate.velocities, rate.forces))];
    std::sort(
      result.values.begin(),
      result.values.end(),
      [](const auto a, const auto b) { return std::abs(a) > std::abs(b); });
    bool is_left_out = false;
    for (const std::complex<double> m : result.values)
      if (m == result.trivial && !is_left_out)
        is_left_out = true;
      else
        result.largest = std::max(result.largest, std::abs(m));
    return result;
  }
} // namespace squeal
