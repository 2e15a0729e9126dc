// SPDX-License-Identifier: LGPL-2.1-or-later

// A periodic motion with a known answer: a mass on a massless spring against a
// wall.

#include "scenes.h"
#include "transient/hand_made.h"
#include "worst.h"

#include <squeal/cycle/harmonic_balance.h>

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
} // namespace

int
main()
{
  wall();
}
