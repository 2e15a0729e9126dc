// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/cycle/period_equations.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace squeal
{
  namespace
  {
    /** A vibration below this share of the sliding speed is steady sliding. */
    constexpr double at_rest = 1e-6;

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
  } // namespace



  ScaledMotion::ScaledMotion(const ReducedContactModel &model,
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
        scale[k] =
          std::sqrt(std::max(model.omega_squared[k], 1e-4 * lowest * lowest));
        scale[n + k] = 1.;
      }
    for (std::size_t i = 0; i < rows.size(); ++i)
      scale[2 * n + i] =
        std::sqrt(std::max(model.flexibility(rows[i], rows[i]),
                           std::numeric_limits<double>::min()));
  }

  Eigen::VectorXd
  ScaledMotion::pack(const Eigen::VectorXd &q,
                     const Eigen::VectorXd &v,
                     const Eigen::VectorXd &lambda) const
  {
    Eigen::VectorXd x(scale.size());
    x << q, v, lambda(rows);
    return x.cwiseProduct(scale);
  }

  Eigen::VectorXd
  ScaledMotion::difference(const MotionState &a, const MotionState &b) const
  {
    return pack(a.coordinates - b.coordinates,
                a.velocities - b.velocities,
                a.forces - b.forces);
  }

  MotionState
  ScaledMotion::moved(const MotionState     &start,
                      const Eigen::VectorXd &change) const
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
  ScaledMotion::derivative(const Eigen::MatrixXd &D) const
  {
    return scale.asDiagonal() * D * scale.cwiseInverse().asDiagonal();
  }



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



  MotionState
  rate_of_motion(const PeriodMap &map, const Orbit &orbit)
  {
    const MotionState &start = orbit.states.front();
    return {start.velocities,
            map.acceleration(start).tail(start.velocities.size()),
            (orbit.end().forces - orbit.states[orbit.n_steps() - 1].forces) /
              orbit.step};
  }



  double
  motion_size(const ReducedContactModel &model, const Orbit &orbit)
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



  bool
  is_steady(const PeriodMap &map, const Orbit &orbit)
  {
    return vibration(map, orbit) < at_rest;
  }

  std::optional<PeriodicMotion>
  located_anew(const PeriodMap &map, const PeriodicMotion &motion)
  {
    const Orbit   &orbit = motion.orbit;
    PeriodicMotion located;
    if (!try_orbit(map,
                   orbit.states.front(),
                   motion.period,
                   orbit.n_steps(),
                   orbit.past_of(orbit.n_steps()),
                   nullptr,
                   located,
                   &orbit))
      return {};
    return located;
  }

  bool
  try_orbit(const PeriodMap       &map,
            const MotionState     &start,
            const double           period,
            const unsigned int     n_steps,
            const ContactPast     &past,
            const StepCorrections *held,
            PeriodicMotion        &m,
            const Orbit           *neighbour)
  {
    try
      {
        m.orbit = map.run(start, period, n_steps, past, held, neighbour);
      }
    catch (const ComputationError &)
      {
        return false;
      }
    catch (const InputError &) // a period too long for its steps
      {
        return false;
      }
    m.period   = period;
    m.is_held  = held != nullptr;
    m.residual = energy_norm(map.reduced_model(), m.orbit.end(), start) /
                 motion_size(map.reduced_model(), m.orbit);
    return std::isfinite(m.residual);
  }



  PeriodEquations::PeriodEquations(const PeriodMap        &map,
                                   const PeriodicMotion   &m,
                                   const ScaledMotion     &scaled,
                                   const std::vector<int> &rows,
                                   const StatusChanges     changes)
  {
    const Orbit          &orbit = m.orbit;
    const Eigen::MatrixXd D =
      scaled.derivative(map.derivative(orbit, rows, changes));
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
    A                    = Eigen::MatrixXd::Zero(n + 1, n + 1);
    A.topLeftCorner(n, n).setIdentity();
    A.topLeftCorner(n, n) -= D;
    A.col(n).head(n) = -m.period * end_rate;
    A.row(n).head(n) = start_rate.transpose() / start_rate.norm();
    rhs              = Eigen::VectorXd::Zero(n + 1);
    rhs.head(n)      = scaled.difference(end, start);
    factors.compute(A);
  }

  Eigen::VectorXd
  PeriodEquations::solve(const Eigen::VectorXd &missing) const
  {
    Eigen::VectorXd b      = Eigen::VectorXd::Zero(A.rows());
    b.head(missing.size()) = missing;
    return factors.solve(b);
  }

  Eigen::VectorXd
  PeriodEquations::solve_with(const Eigen::VectorXd &by_number,
                              const Eigen::VectorXd &row,
                              const double           value) const
  {
    const Eigen::Index n  = A.rows();
    Eigen::MatrixXd    B  = Eigen::MatrixXd::Zero(n + 1, n + 1);
    B.topLeftCorner(n, n) = A;
    B.col(n).head(n - 1)  = -by_number;
    B.row(n)              = row.transpose();
    Eigen::VectorXd b(n + 1);
    b << rhs, value;
    return B.partialPivLu().solve(b);
  }
} // namespace squeal
