// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/cycle/shooting.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>

namespace squeal
{
  namespace
  {
    /** A vibration below this share of the sliding speed is steady sliding. */
    constexpr double at_rest = 1e-6;
    /** The period changes by no more than this share in an iteration. */
    constexpr double largest_change = 0.1;
    /** Shortest step of Newton's method over its full one. */
    constexpr double shortest_step = 1. / 64.;

    /** State and period as one vector, each entry in the root of an energy. */
    class Scaled
    {
    public:
      Scaled(const ReducedContactModel &model,
             const std::vector<int>    &r,
             const double               period)
        : rows(r)
        , n(model.n_modes())
        , scale(2 * n + r.size())
      {
        // Floating bodies have no stiffness of their own.
        const double lowest = 2. * M_PI / period;
        for (Eigen::Index k = 0; k < n; ++k)
          {
            scale[k] = std::sqrt(
              std::max(model.omega_squared[k], 1e-4 * lowest * lowest));
            scale[n + k] = 1.;
          }
        for (std::size_t i = 0; i < rows.size(); ++i)
          scale[2 * n + i] =
            std::sqrt(std::max(model.flexibility(rows[i], rows[i]),
                               std::numeric_limits<double>::min()));
      }

      Eigen::VectorXd
      pack(const Eigen::VectorXd &q,
           const Eigen::VectorXd &v,
           const Eigen::VectorXd &lambda) const
      {
        Eigen::VectorXd x(scale.size());
        x << q, v, lambda(rows);
        return x.cwiseProduct(scale);
      }

      Eigen::VectorXd
      difference(const MotionState &a, const MotionState &b) const
      {
        return pack(a.coordinates - b.coordinates,
                    a.velocities - b.velocities,
                    a.forces - b.forces);
      }

      MotionState
      moved(const MotionState &start, const Eigen::VectorXd &change) const
      {
        const Eigen::VectorXd x      = change.cwiseQuotient(scale);
        MotionState           result = start;
        result.coordinates += x.head(n);
        result.velocities += x.segment(n, n);
        for (std::size_t i = 0; i < rows.size(); ++i)
          result.forces[rows[i]] += x[2 * n + i];
        return result;
      }

      Eigen::MatrixXd
      derivative(const Eigen::MatrixXd &D) const
      {
        return scale.asDiagonal() * D * scale.cwiseInverse().asDiagonal();
      }

    private:
      const std::vector<int> rows;
      const Eigen::Index     n;
      Eigen::VectorXd        scale;
    };

    /** Of the motion about its mean, the largest energy norm. */
    double
    size_of(const ReducedContactModel &model, const Orbit &orbit)
    {
      MotionState mean = orbit.states.back();
      for (std::size_t i = 1; i + 1 < orbit.states.size(); ++i)
        {
          mean.coordinates += orbit.states[i].coordinates;
          mean.velocities += orbit.states[i].velocities;
          mean.forces += orbit.states[i].forces;
        }
      mean.coordinates /= orbit.n_steps();
      mean.velocities /= orbit.n_steps();
      mean.forces /= orbit.n_steps();
      double result = 0.;
      for (const MotionState &state : orbit.states)
        result = std::max(result, energy_norm(model, state, mean));
      return result;
    }

    /** Largest velocity of contact nodes over the sliding speed. */
    double
    vibration(const PeriodMap &map, const Orbit &orbit)
    {
      double result = 0.;
      for (const MotionState &state : orbit.states)
        result = std::max(result,
                          (map.reduced_model().participation * state.velocities)
                            .cwiseAbs()
                            .maxCoeff());
      return result / std::abs(map.sliding_speed());
    }

    /** Newton's step (state, period) from the orbit at hand. */
    Eigen::VectorXd
    newton_step(const PeriodMap        &map,
                const PeriodicMotion   &m,
                const Scaled           &scaled,
                const std::vector<int> &rows)
    {
      const Orbit          &orbit = m.orbit;
      const Eigen::MatrixXd D = scaled.derivative(map.derivative(orbit, rows));
      const MotionState    &start = orbit.states.front(), &end = orbit.end();
      const MotionState    &before = orbit.states[orbit.n_steps() - 1];
      const Eigen::VectorXd end_rate =
        scaled.pack(end.velocities,
                    map.acceleration(end),
                    (end.forces - before.forces) / orbit.step);
      const Eigen::VectorXd start_rate =
        scaled.pack(start.velocities,
                    map.acceleration(start),
                    Eigen::VectorXd::Zero(start.forces.size()));
      const Eigen::Index n = D.rows();
      Eigen::MatrixXd    A = Eigen::MatrixXd::Zero(n + 1, n + 1);
      A.topLeftCorner(n, n).setIdentity();
      A.topLeftCorner(n, n) -= D;
      // The period in shares of itself.
      A.col(n).head(n)    = -m.period * end_rate;
      A.row(n).head(n)    = start_rate.transpose() / start_rate.norm();
      Eigen::VectorXd rhs = Eigen::VectorXd::Zero(n + 1);
      rhs.head(n)         = scaled.difference(end, start);
      return A.partialPivLu().solve(rhs);
    }

    /** The orbit that starts there with what it misses; false where a step has
     * no solution. */
    bool
    try_orbit(const PeriodMap   &map,
              const MotionState &start,
              const double       period,
              const unsigned int n_steps,
              const ContactPast &past,
              PeriodicMotion    &m)
    {
      try
        {
          m.orbit = map.run(start, period, n_steps, past);
        }
      catch (const ComputationError &)
        {
          return false;
        }
      m.period   = period;
      m.residual = energy_norm(map.reduced_model(), m.orbit.end(), start) /
                   size_of(map.reduced_model(), m.orbit);
      return std::isfinite(m.residual);
    }
  } // namespace



  double
  energy_norm(const ReducedContactModel &model,
              const MotionState         &a,
              const MotionState         &b)
  {
    const Eigen::VectorXd q      = a.coordinates - b.coordinates,
                          lambda = a.forces - b.forces;
    return std::sqrt((a.velocities - b.velocities).squaredNorm() +
                     model.omega_squared.dot(q.cwiseAbs2()) +
                     lambda.dot(model.flexibility * lambda));
  }



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
    if (!try_orbit(map, start, period, settings.n_steps, {}, m))
      return m;
    for (;; ++m.iterations)
      {
        m.history.push_back(m.residual);
        if (vibration(map, m.orbit) < at_rest)
          {
            m.status = CycleStatus::steady_sliding;
            return m;
          }
        if (m.residual <= settings.tolerance)
          {
            m.status = CycleStatus::converged;
            return m;
          }
        if (m.iterations >= settings.iterations)
          return m;
        const std::vector<int> rows = map.closed_rows(m.orbit);
        const Scaled           scaled(map.reduced_model(), rows, m.period);
        const Eigen::VectorXd  change = newton_step(map, m, scaled, rows);
        if (!change.allFinite())
          return m;
        const double turn = std::abs(change[change.size() - 1]);
        double       step = std::min(1., largest_change / turn);
        // In a periodic motion the start's past is that of the end.
        const ContactPast past = m.orbit.past_of(settings.n_steps);
        PeriodicMotion    best;
        best.residual = std::numeric_limits<double>::max();
        for (; step >= shortest_step; step *= .5)
          {
            PeriodicMotion next;
            if (try_orbit(map,
                          scaled.moved(m.orbit.states.front(),
                                       step * change.head(change.size() - 1)),
                          m.period * (1. + step * change[change.size() - 1]),
                          settings.n_steps,
                          past,
                          next) &&
                next.residual < best.residual)
              best = std::move(next);
            if (best.residual < (1. - .2 * step) * m.residual)
              break;
          }
        if (!(best.residual < m.residual))
          return m;
        m.orbit    = std::move(best.orbit);
        m.period   = best.period;
        m.residual = best.residual;
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

  double
  FloquetMultipliers::uncertainty() const
  {
    return std::max(error, std::abs(trivial - 1.));
  }

  FloquetMultipliers
  floquet_multipliers(const PeriodMap &map, const PeriodicMotion &motion)
  {
    const std::vector<int> rows = map.closed_rows(motion.orbit);
    const Scaled           scaled(map.reduced_model(), rows, motion.period);
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
