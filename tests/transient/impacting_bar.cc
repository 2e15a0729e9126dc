// SPDX-License-Identifier: LGPL-2.1-or-later

// An elastic bar thrown at a rigid wall (Doyen, Ern, Piperno, SIAM J. Sci.
// Comput. 33, 2011): pressure and time of contact, energy, and how they
// converge with modes and step.

#include "scenes.h"
#include "transient/hand_made.h"

#include <squeal/transient/reduced_transient.h>

#include <cmath>
#include <cstdio>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  // Per unit of cross-section.
  constexpr double young = 900., density = 1., length = 10., distance = 5.,
                   velocity = 10.;
  constexpr double wave     = 30.;                 /**< sqrt(E/rho) */
  constexpr double pressure = 300.;                /**< rho c v_0 */
  constexpr double touch    = distance / velocity; /**< from then on */
  constexpr double contact  = 2. * length / wave;  /**< for so long */
  constexpr double noise    = 1e-6 * pressure;
  constexpr double energy   = .5 * density * length * velocity * velocity;

  /** The rigid motion and @p n free-free modes cos(k pi x/L) of the bar, the
   * others as flexibility at x = 0. */
  ReducedContactModel
  bar(const unsigned int n)
  {
    const double        mass = density * length;
    ReducedContactModel m    = empty_model(1, n + 1);
    m.initial_gap[0]         = distance;
    double rest              = M_PI * M_PI / 6.;
    for (unsigned int k = 0; k <= n; ++k)
      {
        const double omega    = k * M_PI * wave / length;
        m.omega_squared[k]    = omega * omega;
        m.participation(0, k) = -std::sqrt((k == 0 ? 1. : 2.) / mass);
        if (k > 0)
          rest -= 1. / (double(k) * k);
      }
    // Frictionless: the tangential parts play no role.
    m.flexibility = Eigen::MatrixXd::Identity(3, 3);
    m.flexibility(0, 0) =
      2. / mass * std::pow(length / (M_PI * wave), 2) * rest;
    return m;
  }

  struct Impact
  {
    double       start = -1., end = 0.;     /**< of the contact, s */
    double       mean_force = 0., rms = 0.; /**< rms of force - pressure */
    double       late_rms  = 0.; /**< in the middle half of the contact */
    double       highest   = 0.;
    double       impulse   = 0.; /**< over 2 m v_0 */
    double       rebound   = 0.; /**< mean velocity over v_0 */
    double       lost      = 0.; /**< by the scheme, share */
    double       vibration = 0.; /**< energy left in modes, share */
    double       imbalance = 0.;
    unsigned int n_touches = 0;
  };

  Impact
  thrown(const unsigned int n, const double dt)
  {
    const ReducedContactModel m = bar(n);
    ReducedTransient          run(m, dt, steady_drive(0., 0.), pressure, 1e-10);
    Eigen::VectorXd           v = Eigen::VectorXd::Zero(n + 1);
    v[0]                        = -std::sqrt(density * length) * velocity;
    run.start(Eigen::VectorXd::Zero(n + 1), v, Eigen::VectorXd::Zero(3));
    Impact r;
    double before = 0., late = 0.;
    for (unsigned int i = 1; i * dt < 1.5; ++i)
      {
        run.advance();
        const double f = run.forces()[0], t = run.time();
        r.impulse += .5 * dt * (f + before);
        if (f > noise && before <= noise)
          ++r.n_touches;
        if (f > noise && r.start < 0.)
          r.start = t;
        if (f > noise)
          r.end = t;
        r.highest = std::max(r.highest, f);
        if (t > touch && t < touch + contact)
          r.rms += dt * std::pow(f / pressure - 1., 2);
        if (t > touch + .25 * contact && t < touch + .75 * contact)
          {
            r.late_rms += dt * std::pow(f / pressure - 1., 2);
            r.mean_force += dt * f;
            late += dt;
          }
        before = f;
      }
    r.rms      = std::sqrt(r.rms / contact);
    r.late_rms = std::sqrt(r.late_rms / late);
    r.mean_force /= late;
    r.impulse /= 2. * density * length * velocity;
    r.rebound = run.velocities()[0] / (std::sqrt(density * length) * velocity);
    r.lost    = (energy - run.ledger().kinetic - run.ledger().elastic) / energy;
    r.vibration = 1. - r.lost - r.rebound * r.rebound;
    r.imbalance = run.ledger().imbalance();
    std::printf("n %3u, dt %.2e: contact %.5f to %.5f in %u, mean force %.5f, "
                "rms error %.4f, middle %.5f, highest %.3f, impulse %.6f, "
                "rebound %.6f, lost %.2e, vibration %.2e, ledger %.1e\n",
                n,
                dt,
                r.start,
                r.end,
                r.n_touches,
                r.mean_force / pressure,
                r.rms,
                r.late_rms,
                r.highest / pressure,
                r.impulse,
                r.rebound,
                r.lost,
                r.vibration,
                r.imbalance);
    return r;
  }
} // namespace

int
main()
{
  for (const unsigned int n : {10, 20, 40, 80, 160})
    thrown(n, 1e-5);
  for (const double dt : {8e-4, 4e-4, 2e-4, 1e-4, 5e-5, 2.5e-5})
    thrown(40, dt);
}
