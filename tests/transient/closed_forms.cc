// SPDX-License-Identifier: LGPL-2.1-or-later

// Contact with closed forms, on models made by hand: a block that slides to
// rest, a block on an incline, Spurr's rod, and Hertz's and Cattaneo and
// Mindlin's contacts on half-spaces.

#include "scenes.h"
#include "transient/hand_made.h"

#include <squeal/base/exceptions.h>
#include <squeal/transient/reduced_transient.h>
#include <squeal/transient/steady_sliding.h>

#include <cmath>
#include <cstdio>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  constexpr double gravity = 9.81;

  /** A block put on a moving floor: it slides until it moves with the floor. */
  void
  sliding_block()
  {
    const double mass = 2.5, mu = .3, v = 1.2;
    const double time = v / (mu * gravity), way = v * v / (2. * mu * gravity);
    double       before = 0.;
    for (const double dt : {time / 210.3, time / 2010.3})
      {
        ReducedContactModel m = rigid_block(mass, dt);
        m.load[0]             = -std::sqrt(mass) * gravity;
        ReducedTransient run(m, dt, steady_drive(mu, v), mass * gravity, 1e-10);
        Eigen::VectorXd  q = Eigen::VectorXd::Zero(3), forces(3);
        // It slides from the start on.
        forces << mass * gravity, mu * mass * gravity, 0.;
        q[0] = -std::sqrt(mass) * m.flexibility(0, 0) * forces[0];
        run.start(q, Eigen::VectorXd::Zero(3), forces);
        double slid = 0., last = run.motion()[1], stop = 0.;
        while (run.time() < 1.5 * time)
          {
            run.advance();
            if (stop == 0.)
              slid += v * dt + run.motion()[1] - last;
            last = run.motion()[1];
            if (run.status()[0] == ContactStatus::stick && stop == 0.)
              stop = run.time();
          }
        const EnergyLedger e     = run.ledger();
        const double       error = std::abs(slid / way - 1.);
        std::printf("block, %g steps: way %.8f (%.8f), time %.6f (%.6f), "
                    "dissipated %.8f (%.8f) J\n",
                    time / dt,
                    slid,
                    way,
                    stop,
                    time,
                    e.friction,
                    mu * mass * gravity * way);
        check(stop > 0., "comes to rest on the floor");
        check_below(std::abs(stop - time), 2. * dt, "when it should");
        check_below(std::abs(e.friction / (mu * mass * gravity * way) - 1.),
                    before > 0. ? 1e-4 : 1e-2,
                    "dissipates mu m g d");
        // Forces that jump within a step do other work than their mean.
        check_below(e.imbalance(), 1e-5, "the ledger closes");
        if (before > 0.)
          {
            check_below(error, 1e-4, "stopping distance v^2/(2 mu g)");
            check_below(error, before / 5., "falls with the step");
          }
        before = error;
      }
  }

  /** Down an incline: at rest below the angle of friction, accelerated by
   * g (sin - mu cos) above it. */
  void
  incline()
  {
    const double mass = 2., mu = .4, dt = 1e-3, end = .2;
    for (const double tangent : {.99 * mu, 1.01 * mu, 2. * mu})
      {
        ReducedContactModel m     = rigid_block(mass, dt);
        const double        angle = std::atan(tangent);
        m.load[0] = -std::sqrt(mass) * gravity * std::cos(angle);
        m.load[1] = -std::sqrt(mass) * gravity * std::sin(angle);
        ReducedTransient run(
          m, dt, steady_drive(mu, 0.), mass * gravity, 1e-10);
        Eigen::VectorXd q = Eigen::VectorXd::Zero(3), forces(3);
        forces << mass * gravity * std::cos(angle), 0., 0.;
        q[0] = -std::sqrt(mass) * m.flexibility(0, 0) * forces[0];
        run.start(q, Eigen::VectorXd::Zero(3), forces);
        while (run.time() < end)
          run.advance();
        const double a =
          std::max(0., gravity * (std::sin(angle) - mu * std::cos(angle)));
        std::printf("incline, tan %.4f: slid %.8f, %.8f by theory\n",
                    tangent,
                    run.motion()[1],
                    .5 * a * run.time() * run.time());
        // Friction grows to its limit within the first step.
        check_below(
          std::abs(run.motion()[1] - .5 * a * run.time() * run.time()),
          2. * mu * gravity * dt * run.time(),
          "tan " + number(tangent) + ": the way down");
      }
  }



  /** A rod on a pivot leans at an angle to the surface and is dragged into it:
   * F = mu L / (1 - mu tan angle), locks at mu = cot angle. */
  void
  spurr()
  {
    const double angle = 1.1, limit = 1. / std::tan(angle), load = 10.;
    // One mode of unit inertia; a soft spring turns it back. Pressing it turns
    // the tip down by cos and, seen from the moving surface, by sin along it.
    ReducedContactModel m = empty_model(1, 1);
    m.omega_squared[0]    = 1.;
    m.participation(0, 0) = std::cos(angle);
    m.participation(1, 0) = -std::sin(angle);
    m.load[0]             = load * std::cos(angle);
    m.flexibility         = 1e-9 * Eigen::MatrixXd::Identity(3, 3);
    for (const double share : {.5, .9, .999})
      {
        const double        mu    = share * limit;
        const SteadySliding state = steady_sliding(m, mu);
        const double        exact = mu * load / (1. - mu * std::tan(angle));
        std::printf("sprag, %.3f of the limit: friction %.6f (%.6f) N\n",
                    share,
                    state.forces[1],
                    exact);
        check_below(std::abs(state.forces[1] / exact - 1.),
                    1e-5,
                    "friction at " + number(share) + " of the limit");
      }
    for (const double share : {1.001, 1.2})
      {
        bool found = true;
        try
          {
            steady_sliding(m, share * limit);
          }
        catch (const ComputationError &e)
          {
            found                  = false;
            const std::string text = e.what();
            std::printf("%s\n", text.c_str());
            const double reached =
              std::stod(text.substr(text.find("mu = ") + 5));
            check_below(std::abs(reached / limit - 1.),
                        3e-3,
                        "the largest friction that slides is named");
          }
        check(!found, "sprags at " + number(share) + " of the limit");
      }
  }



  /** Two equal half-spaces, n x n square cells of side h: compliances under
   * even tractions (Love 1929, Cerruti), u_z by the pressure, u_x by the
   * traction along x; the small coupling of x and y left out, as in the closed
   * form. */
  struct HalfSpaces
  {
    double young = 70e9, poisson = .3, cell;
    int    n;

    /** Integral of 1/r over a cell at (x, y), split into the parts that change
     * with x^2/r^3 and y^2/r^3. */
    std::array<double, 2>
    integrals(const double x, const double y) const
    {
      double along = 0., across = 0.;
      for (const int i : {-1, 1})
        for (const int j : {-1, 1})
          {
            const double a = x + .5 * i * cell, b = y + .5 * j * cell,
                         r = std::hypot(a, b);
            along += i * j * b * std::log(a + r);
            across += i * j * a * std::log(b + r);
          }
      return {{along, across}};
    }

    /** Per force on a cell, m/N; normal, along, across. */
    Eigen::Vector3d
    compliance(const double x, const double y) const
    {
      const auto [along, across] = integrals(x, y);
      const double scale = 2. * (1. + poisson) / (M_PI * young) / (cell * cell);
      return scale * Eigen::Vector3d(
                       (1. - poisson) * (along + across),
                       (1. - poisson) * (along + across) + poisson * along,
                       (1. - poisson) * (along + across) + poisson * across);
    }

    Eigen::Vector2d
    centre(const int k) const
    {
      return cell * Eigen::Vector2d(k % n - .5 * (n - 1), k / n - .5 * (n - 1));
    }

    Eigen::MatrixXd
    flexibility() const
    {
      Eigen::MatrixXd G = Eigen::MatrixXd::Zero(3 * n * n, 3 * n * n);
      for (int i = 0; i < n * n; ++i)
        for (int k = 0; k < n * n; ++k)
          {
            const Eigen::Vector2d d = centre(i) - centre(k);
            const Eigen::Vector3d c = compliance(d[0], d[1]);
            for (int part = 0; part < 3; ++part)
              G(3 * i + part, 3 * k + part) = c[part];
          }
      return G;
    }
  };

  constexpr double radius_of_sphere = 20e-3, force = 100.;

  struct Hertz
  {
    double radius, pressure, approach;
  };

  Hertz
  hertz(const HalfSpaces &h)
  {
    const double E = .5 * h.young / (1. - h.poisson * h.poisson);
    const double a = std::cbrt(3. * force * radius_of_sphere / (4. * E));
    return {a, 1.5 * force / (M_PI * a * a), a * a / radius_of_sphere};
  }

  /** Half-spaces in @p n cells across 2.4 contact radii, pressed together. */
  SteadySliding
  press(HalfSpaces &h, ReducedContactModel &m)
  {
    h.cell = 1.;
    h.cell = 2.4 * hertz(h).radius / h.n;
    m      = empty_model(h.n * h.n, 1);
    for (int k = 0; k < h.n * h.n; ++k)
      {
        m.participation(3 * k, 0) = 1.;
        m.initial_gap[k] = h.centre(k).squaredNorm() / (2. * radius_of_sphere);
      }
    m.load[0]     = force;
    m.flexibility = h.flexibility();
    return steady_sliding(m, 0.);
  }

  void
  sphere()
  {
    double before = 0.;
    for (const int n : {9, 17, 25})
      {
        HalfSpaces h;
        h.n = n;
        ReducedContactModel m;
        const SteadySliding s     = press(h, m);
        const Hertz         exact = hertz(h);
        const double        cell  = h.cell * h.cell;
        const double        p     = s.forces[3 * (n * n / 2)] / cell,
                     a            = std::sqrt(s.n_closed() * cell / M_PI),
                     d            = s.coordinates[0];
        const double error        = std::abs(d / exact.approach - 1.);
        const double peak_error   = std::abs(p / exact.pressure - 1.);
        std::printf("sphere, %d cells: p0 %.4f, a %.4f, approach %.6f of "
                    "Hertz's\n",
                    n,
                    p / exact.pressure,
                    a / exact.radius,
                    d / exact.approach);
        check_below(std::abs(a - exact.radius), h.cell, "radius of contact");
        check_below(std::abs(s.resultant()[0] / force - 1.), 1e-9, "the load");
        if (before > 0.)
          check_below(peak_error, .6 * before, "p0 converges");
        before = peak_error;
        if (n == 25)
          {
            check_below(peak_error, .02, "p0");
            check_below(error, 5e-3, "approach a^2/R");
          }
      }
  }

  void
  partial_slip()
  {
    const double mu = .4;
    HalfSpaces   h;
    h.n = 25;
    ReducedContactModel m;
    const SteadySliding s     = press(h, m);
    const Hertz         exact = hertz(h);
    // Now the approach and a shift along are given.
    ContactSolver solver(m.flexibility,
                         m.initial_gap,
                         m.speed_ratio,
                         force / s.n_closed(),
                         1e-9,
                         ContactSolver::Precision::full);
    const double  G = .5 * h.young / (1. + h.poisson), a = exact.radius;
    const double  full_shift =
      3. * mu * force / (16. * a) * 2. * (2. - h.poisson) / G;
    for (const double share : {.3, .6, .9})
      {
        const double shift = full_shift * (1. - std::pow(1. - share, 2. / 3.));
        ContactStep  step;
        step.duration        = 0.;
        step.speed           = 0.;
        step.friction        = mu;
        step.previous_motion = Eigen::VectorXd::Zero(s.forces.size());
        step.free_motion     = Eigen::VectorXd::Zero(s.forces.size());
        for (unsigned int k = 0; k < m.n_nodes(); ++k)
          {
            step.free_motion[3 * k]     = s.coordinates[0];
            step.free_motion[3 * k + 1] = shift;
          }
        Eigen::VectorXd lambda = s.forces;
        solver.solve(step, lambda);
        double       Q       = 0.;
        unsigned int n_stick = 0;
        for (unsigned int k = 0; k < m.n_nodes(); ++k)
          {
            Q += lambda[3 * k + 1];
            n_stick += solver.status()[k] == ContactStatus::stick;
          }
        const double c       = std::sqrt(n_stick * h.cell * h.cell / M_PI),
                     c_exact = a * std::cbrt(1. - share);
        std::printf("shift for Q/(mu P) = %.2f: %.4f, stick radius %.4f "
                    "(%.4f) of a, cell %.4f\n",
                    share,
                    Q / (mu * force),
                    c / a,
                    c_exact / a,
                    h.cell / a);
        check_below(std::abs(c - c_exact), h.cell, "stick radius");
        check_below(
          std::abs(Q / (mu * force) - share), .02, "tangential force");
      }
  }
} // namespace

int
main(int argc, char *argv[])
{
  const std::string which = argc > 1 ? argv[1] : "";
  if (which == "block")
    {
      sliding_block();
      incline();
    }
  else if (which == "sprag")
    spurr();
  else if (which == "half_spaces")
    {
      sphere();
      partial_slip();
    }
  else
    check(false, "an argument: block, sprag or half_spaces");
}
