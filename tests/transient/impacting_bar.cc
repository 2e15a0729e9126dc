// SPDX-License-Identifier: LGPL-2.1-or-later

// An elastic bar thrown at a rigid wall (Doyen, Ern, Piperno, SIAM J. Sci.
// Comput. 33, 2011): pressure and time of contact, energy, and how they
// converge with modes and step.

#include "scenes.h"
#include "transient/hand_made.h"
#include "worst.h"

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
    m.cut_off                = (n + .5) * wave / (2. * length);
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

  /** All modes of @p n cells with masses at the nodes. The node at the wall has
   * none: its share is with the next one. */
  ReducedContactModel
  mesh(const unsigned int n)
  {
    const double    cell = length / n, spring = young / cell;
    Eigen::VectorXd mass = Eigen::VectorXd::Constant(n, density * cell);
    mass[0] *= 1.5;
    mass[n - 1] *= .5;
    Eigen::MatrixXd K = Eigen::MatrixXd::Zero(n, n);
    for (unsigned int i = 0; i + 1 < n; ++i)
      K.block<2, 2>(i, i) +=
        spring * (Eigen::Matrix2d() << 1., -1., -1., 1.).finished();
    const Eigen::VectorXd scale = mass.cwiseSqrt().cwiseInverse();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(
      Eigen::MatrixXd(scale.asDiagonal() * K * scale.asDiagonal()));
    ReducedContactModel m  = empty_model(1, n);
    m.initial_gap[0]       = distance;
    m.omega_squared        = modes.eigenvalues().cwiseMax(0.);
    m.omega_squared[0]     = 0.;
    m.participation.row(0) = -modes.eigenvectors().row(0) * scale[0] *
                             (modes.eigenvectors()(0, 0) > 0. ? 1. : -1.);
    m.flexibility       = Eigen::MatrixXd::Identity(3, 3);
    m.flexibility(0, 0) = 1. / spring;
    return m;
  }

  struct Impact
  {
    double       start = -1., end = 0.;     /**< of the contact, s */
    double       mean_force = 0., rms = 0.; /**< rms of force - pressure */
    double       late_rms = 0.; /**< in the middle half of the contact */
    Worst        highest;
    double       impulse   = 0.; /**< over 2 m v_0 */
    double       rebound   = 0.; /**< mean velocity over v_0 */
    double       lost      = 0.; /**< by the scheme, share */
    double       vibration = 0.; /**< energy left in modes, share */
    double       imbalance = 0.;
    double       ringing   = 0.; /**< of the pressure about its mean, Hz */
    unsigned int n_touches = 0;
  };

  Impact
  thrown(const std::string &name, const ReducedContactModel &m, const double dt)
  {
    ReducedTransient run(m, dt, steady_drive(0., 0.), pressure, 1e-10);
    Eigen::VectorXd  v = Eigen::VectorXd::Zero(m.n_modes());
    v[0]               = -std::sqrt(density * length) * velocity;
    run.start(Eigen::VectorXd::Zero(m.n_modes()), v, Eigen::VectorXd::Zero(3));
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
        r.highest.add(f);
        if (t > touch && t < touch + contact)
          r.rms += dt * std::pow(f / pressure - 1., 2);
        if (t > touch + .25 * contact && t < touch + .75 * contact)
          {
            r.late_rms += dt * std::pow(f / pressure - 1., 2);
            r.mean_force += dt * f;
            late += dt;
            r.ringing += f > pressure && before <= pressure;
          }
        before = f;
      }
    r.rms      = std::sqrt(r.rms / contact);
    r.late_rms = std::sqrt(r.late_rms / late);
    r.mean_force /= late;
    r.ringing /= late;
    r.impulse /= 2. * density * length * velocity;
    r.rebound = run.velocities()[0] / (std::sqrt(density * length) * velocity);
    r.lost    = (energy - run.ledger().kinetic - run.ledger().elastic) / energy;
    r.vibration = 1. - r.lost - r.rebound * r.rebound;
    r.imbalance = run.ledger().imbalance();
    std::printf(
      "%s, dt %.2e: contact %.5f to %.5f in %u, mean force %.5f, "
      "rms error %.4f, middle %.5f at %.2f Hz, highest %.3f, impulse %.6f, "
      "rebound %.6f, lost %.2e, vibration %.2e, ledger %.1e\n",
      name.c_str(),
      dt,
      r.start,
      r.end,
      r.n_touches,
      r.mean_force / pressure,
      r.rms,
      r.late_rms,
      r.ringing,
      r.highest.largest() / pressure,
      r.impulse,
      r.rebound,
      r.lost,
      r.vibration,
      r.imbalance);
    return r;
  }

  /** Error of the pressure in the middle of the contact goes, and the contact
   * ends as it should, as the mesh is refined. */
  void
  meshes()
  {
    double before = 0.;
    for (const unsigned int n : {40, 80, 160, 320})
      {
        const std::string name = "mesh of " + number(n);
        const Impact      r    = thrown(name, mesh(n), 1e-5);
        const double      late = r.end - touch - contact;
        check(r.n_touches == 1, name + ": one contact");
        check_below(std::abs(r.start - touch), 2e-5, name + ": it starts");
        check_below(r.late_rms, 2e-4, name + ": pressure rho c v_0");
        check_below(r.highest.largest() / pressure,
                    1.34,
                    name + ": overshoot of the first cells");
        if (before > 0.)
          check_below(late, .62 * before, name + ": the end converges");
        before = late;
      }
    check_below(before / contact, 4e-3, "end of the contact");
  }

  /** Modes up to a cut-off bring impulse, end and rebound; the pressure rings
   * about its mean at x times the cut-off, where the modes below and the
   * flexibility of those above cancel: log((x + 1)/(x - 1)) = 2 x. */
  void
  modes()
  {
    Impact before;
    for (const unsigned int n : {20, 40, 80, 160})
      {
        const std::string name  = number(n) + " modes";
        const Impact      r     = thrown(name, bar(n), 1e-5);
        const double      early = touch + contact - r.end;
        check(r.n_touches == 1, name + ": one contact");
        // One and a half of the periods that are counted.
        check_below(std::abs(r.ringing - 1.19968 * bar(n).cut_off),
                    1.5 / (.5 * contact),
                    name + ": rings at 1.1997 of the cut-off, Hz");
        if (n > 20)
          {
            check_below(std::abs(r.mean_force - pressure),
                        .6 * std::abs(before.mean_force - pressure),
                        name + ": mean pressure converges");
            check_below(early,
                        .6 * (touch + contact - before.end),
                        name + ": the end converges");
            check_below(1. - r.rebound,
                        .6 * (1. - before.rebound),
                        name + ": rebound with v_0 converges");
          }
        before = r;
      }
    check_below(std::abs(before.mean_force / pressure - 1.), 3e-3, "pressure");
    check_below(
      (touch + contact - before.end) / contact, 1e-3, "end of the contact");
    check_below(std::abs(before.impulse - 1.), 1e-4, "impulse 2 m v_0");
    check_below(1. - before.rebound, 1e-4, "rebound with v_0");
  }

  /** Damping at the cut-off takes the ringing away; what it costs of the energy
   * goes with the share of the impact that the modes near it carry. */
  void
  damped()
  {
    check(cut_off_damping(.2, 10e3, 5e3) == .2 / 256. &&
            cut_off_damping(.2, 10e3, 10e3) == .2,
          "the ratio falls as the eighth power below the cut-off");
    check(cut_off_damping(.2, 10e3, 25e3) == .2,
          "motions of the interface far above it have the ratio there");
    Impact before;
    for (const unsigned int n : {40, 80, 160})
      {
        const std::string   name = "damped, " + number(n) + " modes";
        ReducedContactModel m    = bar(n);
        add_cut_off_damping(m, .2);
        const Impact r = thrown(name, m, 1e-5);
        check(r.n_touches == 1, name + ": one contact");
        if (n == 40)
          check_below(r.late_rms, 1e-2, name + ": pressure rho c v_0");
        else
          {
            check_below(r.late_rms,
                        .05 * before.late_rms,
                        name + ": the pressure is that of the bar");
            check_below(r.lost, .6 * before.lost, name + ": energy it takes");
          }
        check_below(r.imbalance, 1e-6, name + ": ledger");
        before = r;
      }
    check_below(before.late_rms, 1e-6, "damped: pressure rho c v_0");
    check_below(before.lost, 4e-3, "damped: energy it takes");
  }

  /** What impacts do to the energy goes with the square of the step. */
  void
  energies()
  {
    for (const bool is_mesh : {true, false})
      {
        const std::string name  = is_mesh ? "mesh of 40" : "40 modes";
        double            first = 0., last = 0.;
        for (const double dt : {8e-4, 4e-4, 2e-4, 1e-4, 5e-5, 2.5e-5})
          {
            const Impact r = thrown(name, is_mesh ? mesh(40) : bar(40), dt);
            last           = std::abs(r.lost);
            if (first == 0.)
              first = last;
            check_below(r.imbalance, 2e-5, name + ": the ledger closes");
          }
        const double order = std::log(first / last) / std::log(32.);
        check(order > 1.7, name + ": energy error of order " + number(order));
        check_below(last, 1e-6, name + ": energy error");
      }
  }
} // namespace

int
main()
{
  meshes();
  modes();
  damped();
  energies();
}
