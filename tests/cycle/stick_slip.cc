// SPDX-License-Identifier: LGPL-2.1-or-later

// The oscillator m = k = N = 1 on a belt with a larger coefficient of friction
// at rest than in slip, whose period and stick duration are known, by shooting:
// the force jumps where the mass lets go, and the steps locate that.

#include "scenes.h"
#include "transient/hand_made.h"
#include "worst.h"

#include <squeal/base/number_text.h>
#include <squeal/cycle/shooting.h>
#include <squeal/cycle/slip_origin.h>

#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  constexpr double belt = .1, kinetic = .3, at_rest = .5;

  // It sticks for 2 D/V, D = (mu_s - mu_k) N/k, and slips for 2 (pi -
  // atan(D/V)).
  const double drop = at_rest - kinetic, stick = 2. * drop / belt,
               period = 2. * (M_PI - std::atan(drop / belt)) + stick;

  CycleFriction
  friction()
  {
    CycleFriction f;
    f.kinetic = Eigen::VectorXd::Constant(1, kinetic);
    f.at_rest = Eigen::VectorXd::Constant(1, at_rest);
    f.speed   = belt;
    return f;
  }

  /** Between the located end and beginning of slip. */
  double
  stick_duration(const PeriodMap &map, const Orbit &orbit)
  {
    double sticks = 0.;
    for (unsigned int i = 0; i < orbit.n_steps(); ++i)
      {
        const ContactPast   past = orbit.past_of(i);
        const ChangesInStep changes(map.reduced_model(),
                                    map.law_of_friction(),
                                    orbit.step,
                                    orbit.states[i].forces,
                                    orbit.motions[i],
                                    past);
        if (const auto share = changes.share(0, orbit.status[i][0]))
          sticks += (orbit.status[i][0] == ContactStatus::slip ? 1. : -1.) *
                    (i + *share) * orbit.step;
      }
    // The period begins amid slip.
    return sticks;
  }

  void
  shooting()
  {
    std::vector<double> errors;
    for (const unsigned int n : {2000u, 4000u, 8000u, 16000u})
      {
        ReducedContactModel m = foot_on_belt(period / n);
        // What nothing holds may stay anywhere across the belt, and what
        // rings on the contact does so for ever.
        m.omega_squared[1] = 1.;
        m.damping[0]       = 2. / std::sqrt(m.flexibility(0, 0));
        const PeriodMap map(m, friction(), 1., 1e-11);
        MotionState     start{
          Eigen::Vector4d(-m.flexibility(0, 0), 0., 0., 0.),
          Eigen::Vector4d(0., 0., -belt / m.participation(1, 2), 0.),
          Eigen::Vector3d(1., 0., 0.)};
        // Through two releases into the slip behind the second one.
        start = map.run(start, 1.86 * period, 1.86 * n).end();
        ShootingSettings settings;
        settings.n_steps          = n;
        settings.tolerance        = 1e-8;
        const PeriodicMotion last = shoot(map, start, 1.02 * period, settings);
        check(last.status == CycleStatus::converged,
              "shooting: converged, " + std::to_string(n) + " steps, to " +
                rounded_text(last.residual, 3) + " in " +
                std::to_string(last.iterations) + " iterations");
        const double             stuck = stick_duration(map, last.orbit);
        const FloquetMultipliers f     = floquet_multipliers(map, last);
        errors.push_back(std::max(std::abs(last.period / period - 1.),
                                  std::abs(stuck / stick - 1.)));
        std::printf("%u steps: period %.8f (%.8f), sticks %.8f (%.8f), trivial "
                    "multiplier %+.2e off 1, largest other %.2e, %u "
                    "iterations\n",
                    n,
                    last.period,
                    period,
                    stuck,
                    stick,
                    f.trivial.real() - 1.,
                    f.largest,
                    last.iterations);
        check_below(std::abs(f.trivial - 1.), 1e-5, "trivial multiplier");
        if (errors.size() > 1)
          check_below(3.8 * errors.back(),
                      errors[errors.size() - 2],
                      "shooting: second order");
      }
    check_below(errors.back(), 1e-5, "shooting: period and stick duration");
  }
} // namespace

int
main()
{
  check_below(std::abs(period - 8.06889), 5e-6, "the published period");
  shooting();
}
