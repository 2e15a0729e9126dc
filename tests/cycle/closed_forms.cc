// SPDX-License-Identifier: LGPL-2.1-or-later

// A periodic motion with a known answer: a mass on a massless spring against a
// wall.

#include "scenes.h"
#include "transient/hand_made.h"
#include "worst.h"

#include <squeal/cycle/harmonic_balance.h>
#include <squeal/cycle/slip_origin.h>

#include <cmath>
#include <cstdio>
#include <string>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  /** A mass of 1 kg that a force of 1 N pushes against a wall behind a massless
   * spring of 1 N/m. */
  ReducedContactModel
  mass_at_wall()
  {
    ReducedContactModel m = empty_model(1, 1);
    m.participation(0, 0) = 1.;
    m.load[0]             = 1.;
    m.flexibility         = Eigen::Matrix3d::Identity();
    return m;
  }

  CycleFriction
  friction_of(const double kinetic, const double at_rest, const double speed)
  {
    CycleFriction f;
    f.kinetic = Eigen::VectorXd::Constant(1, kinetic);
    f.at_rest = Eigen::VectorXd::Constant(1, at_rest);
    f.speed   = speed;
    return f;
  }

  /** The time of a period in which a row of harmonics is above 0. */
  double
  share_above_zero(const Eigen::RowVectorXcd &x)
  {
    constexpr unsigned int n  = 4096;
    const auto             at = [&](const double theta) {
      double value = x[0].real();
      for (Eigen::Index k = 1; k < x.size(); ++k)
        value += 2. * (x[k] * std::polar(1., k * theta)).real();
      return value;
    };
    double sum = 0., before = at(0.);
    for (unsigned int i = 1; i <= n; ++i)
      {
        const double now = at(2. * M_PI * i / n);
        if (before > 0. && now > 0.)
          sum += 1.;
        else if (before > 0. || now > 0.)
          sum += std::max(before, now) / std::abs(now - before);
        before = now;
      }
    return sum / n;
  }

  /** The largest normal force. */
  double
  largest_of(const Eigen::MatrixXd &forces)
  {
    Worst worst;
    for (Eigen::Index i = 0; i < forces.cols(); ++i)
      worst.add(forces(0, i));
    return worst.largest();
  }

  /** With v_0 = 1 m/s at the wall: contact for (pi + 2 atan(1/v_0)) s, flight
   * for 2 v_0 s, largest force 1 + sqrt(1 + v_0^2) N. */
  void
  wall()
  {
    const ReducedContactModel m       = mass_at_wall();
    const double              contact = M_PI + 2. * std::atan(1.), flight = 2.,
                 period = contact + flight, largest = 1. + std::sqrt(2.);
    double         before = 0.;
    HarmonicMotion x;
    for (const unsigned int n : {33u, 65u, 129u, 257u})
      {
        if (before == 0.)
          {
            // A wrong start: a half sine of 60 % of the period.
            x.omega     = 2. * M_PI / period;
            x.forces    = Eigen::MatrixXd::Zero(3, n);
            x.positions = Eigen::VectorXd::Zero(1);
            for (unsigned int i = 0; i < n; ++i)
              x.forces(0, i) =
                std::max(0., 2.6 * std::sin(M_PI * i / (.6 * n)));
          }
        const HarmonicBalance balance(m, friction_of(0., 0., 1.), 1., n);
        x = balance.solve(x, HarmonicBalance::Held::frequency);
        check(x.converged, "wall: converged, " + std::to_string(n));
        const double found =
          share_above_zero(balance.modal_harmonics(x).row(0)) * period;
        const double error = std::abs(found / contact - 1.);
        std::printf("wall, %u samples: contact %.8f s (%.8f), largest force "
                    "%.6f (%.6f), excess damping %.2e, %u iterations\n",
                    n,
                    found,
                    contact,
                    largest_of(x.forces),
                    largest,
                    x.excess_damping,
                    x.iterations);
        if (before > 0.)
          check_below(error, .5 * before, "wall: contact time converges");
        before = error;
      }
    check_below(before, 1e-4, "wall: contact time");
    check_below(std::abs(largest_of(x.forces) / largest - 1.),
                1e-3,
                "wall: largest force");
  }

  /** The time between the located closing and opening of steps that begin at
   * the top of the flight, and what the motion misses after a period. */
  void
  wall_in_steps()
  {
    const ReducedContactModel m = mass_at_wall();
    const PeriodMap           map(m, 0., 1., 1., 1e-13);
    const double contact = M_PI + 2. * std::atan(1.), period = contact + 2.;
    MotionState  start{Eigen::VectorXd::Constant(1, -.5),
                      Eigen::VectorXd::Zero(1),
                      Eigen::VectorXd::Zero(3)};
    double       first = 0., last = 0., first_miss = 0., last_miss = 0.;
    constexpr unsigned int coarse = 100, fine = 3200;
    for (unsigned int n = coarse; n <= fine; n *= 2)
      {
        const Orbit orbit  = map.run(start, period, n);
        double      closed = 0.;
        for (unsigned int i = 2; i < n; ++i)
          {
            const ContactPast   past = orbit.past_of(i);
            const ChangesInStep changes(m,
                                        map.law_of_friction(),
                                        orbit.step,
                                        orbit.states[i].forces,
                                        orbit.motions[i],
                                        past);
            if (const auto share = changes.share(0, orbit.status[i][0]))
              closed += (orbit.status[i][0] == ContactStatus::open ? 1. : -1.) *
                        (i + *share) * orbit.step;
          }
        last      = std::abs(closed / contact - 1.);
        last_miss = std::hypot(orbit.end().coordinates[0] + .5,
                               orbit.end().velocities[0]);
        if (n == coarse)
          {
            first      = last;
            first_miss = last_miss;
          }
        std::printf("wall, %u steps: contact %.8f s (%.8f), misses %.2e after "
                    "a period\n",
                    n,
                    closed,
                    contact,
                    last_miss);
      }
    const auto order = [&](const double a, const double b) {
      return std::log(a / b) / std::log(double(fine) / coarse);
    };
    std::printf("wall: orders %.2f, %.2f\n",
                order(first, last),
                order(first_miss, last_miss));
    check_below(last, 1e-5, "wall: contact time in steps");
    check_below(1.9, order(first, last), "wall: order of the contact time");
    check_below(last_miss, 1e-5, "wall: return after a period");
    check_below(1.9, order(first_miss, last_miss), "wall: order of the return");
  }
} // namespace

int
main()
{
  wall();
  wall_in_steps();
}
