// SPDX-License-Identifier: LGPL-2.1-or-later

// Elastic blocks on a moving rigid floor: one that slides to rest under its own
// weight, and a pressed cube on a floor that starts at once, whose friction its
// shear impedance bounds.

#include "transient/hand_made.h"
#include "transient/pressed_brake.h"
#include "worst.h"

#include <squeal/transient/implicit_transient.h>
#include <squeal/transient/reduced_transient.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  constexpr double gravity = 9.81;

  /** A block of @p size on a floor that neither moves nor gives way; on top of
   * it a load of @p force. */
  SceneParameters
  block_on_floor(const Vector3                     &size,
                 const std::array<unsigned int, 3> &cells,
                 const double                       young,
                 const double                       force)
  {
    SceneParameters s;
    s.bodies                  = {make_block("floor",
                           {{0., 0., -.01}},
                           {{2. * size[0], 2. * size[1], .01}},
                           {{1, 1, 1}}),
                                 make_block("block", {{0., 0., 0.}}, size, cells)};
    s.bodies[1].young_modulus = young;
    s.bodies[1].density       = 2500.;
    s.supports = {make_clamp("floor", "z_min"), make_clamp("floor", "z_max")};
    s.damping.model = DampingParameters::Model::whole_model;
    ContactParameters contact;
    contact.name        = "block on floor";
    contact.source_body = "block";
    contact.source_face = "z_min";
    contact.target_body = "floor";
    contact.target_face = "z_max";
    contact.formulation = ContactParameters::Formulation::mortar;
    s.contacts          = {contact};
    LoadParameters top;
    top.name  = "top";
    top.body  = "block";
    top.face  = "z_max";
    top.force = {{0., 0., -force}};
    s.loads   = {top};
    return s;
  }



  /** Motions of all points by 1 m along component @p c, in the modes. */
  Eigen::VectorXd
  translation(const Reduced &r, const unsigned int c)
  {
    return r.basis.mass_shapes.transpose() * interpolate(
                                               r.discretization,
                                               [c](const dealii::Point<3> &) {
                                                 dealii::Tensor<1, 3> u;
                                                 u[c] = 1.;
                                                 return u;
                                               },
                                               1);
  }

  /** The steady state of the block that friction accelerates as a whole: the
   * motion along y, of unit mass coordinates @p y, is left out, as its inertia
   * balances the friction. */
  SteadySliding
  accelerated(const ReducedContactModel &m,
              const Eigen::VectorXd     &y,
              const double               mu)
  {
    // A reflection turns y into the first coordinate.
    Eigen::VectorXd w = y.normalized();
    w[0] += w[0] > 0. ? 1. : -1.;
    w.normalize();
    const Eigen::Index    n = y.size();
    const Eigen::MatrixXd Q =
      (Eigen::MatrixXd::Identity(n, n) - 2. * w * w.transpose())
        .rightCols(n - 1);
    // The rigid motions alone are mixed.
    ReducedContactModel rest = m;
    rest.omega_squared       = m.omega_squared.tail(n - 1);
    rest.damping             = m.damping.tail(n - 1);
    rest.participation       = m.participation * Q;
    rest.load                = Q.transpose() * m.load;
    SteadySliding s          = steady_sliding(rest, mu);
    s.coordinates            = Q * s.coordinates;
    return s;
  }

  /** Slid way v^2/(2 mu g) of the centre of mass. */
  void
  sliding_to_rest()
  {
    const double    mu = .3, v = .6;
    SceneParameters scene =
      block_on_floor({{.03, .03, .01}}, {{3, 3, 1}}, 1e8, 1.);
    scene.damping.stiffness_damping = 2e-5;
    Reduced               r(scene, 12e3);
    const Eigen::VectorXd y = translation(r, 1), z = translation(r, 2);
    const double          mass = y.squaredNorm();
    check_below(
      std::abs(mass / (2500. * 9e-6) - 1.), 1e-9, "mass of the block");
    Worst worst;
    for (Eigen::Index k = 0; k < y.size(); ++k)
      if (r.model.omega_squared[k] > 0.)
        worst.add(std::abs(y[k]));
    check_below(worst.largest() / std::sqrt(mass),
                1e-6,
                "elastic modes do not move the centre of mass");
    r.model.load = -gravity * z;
    r.model.load_motion.setZero();
    const SteadySliding s = accelerated(
      r.model, (r.model.omega_squared.array() == 0.).select(y, 0.), mu);
    std::printf("%u modes, %u of %u nodes closed, friction %.9f of %.9f N\n",
                r.model.n_modes(),
                s.n_closed(),
                r.model.n_nodes(),
                s.resultant()[1],
                mu * mass * gravity);
    const double time = v / (mu * gravity), way = v * v / (2. * mu * gravity);
    for (const double dt : {1.4e-5, 7e-6})
      {
        ReducedTransient run(
          r.model, dt, steady_drive(mu, v), mass * gravity / r.model.n_nodes());
        run.start(s.coordinates, Eigen::VectorXd::Zero(y.size()), s.forces);
        const double start = y.dot(run.coordinates()) / mass;
        double       stop = 0., first_stick = 0.;
        while (run.time() < 1.2 * time)
          {
            run.advance();
            const auto &status = run.status();
            const auto  n_stick =
              std::count(status.begin(), status.end(), ContactStatus::stick);
            if (first_stick == 0. && n_stick > 0)
              first_stick = run.time();
            if (n_stick == 0)
              stop = run.time();
          }
        const double slid =
          v * run.time() - (y.dot(run.coordinates()) / mass - start);
        const double       error = std::abs(slid / way - 1.);
        const EnergyLedger e     = run.ledger();
        std::printf("elastic block, dt %g: way %.9f (%.9f), error %.2e, first "
                    "stick %.6f, last all slip %.6f (%.6f), heat %.9f (%.9f), "
                    "ledger %.1e\n",
                    dt,
                    slid,
                    way,
                    slid / way - 1.,
                    first_stick,
                    stop,
                    time,
                    e.friction,
                    mu * mass * gravity * way,
                    e.imbalance());
        check(first_stick > 0., "comes to rest on the floor");
        check_below(std::abs(stop - time), 2. * dt, "when it should");
        check_below(error, 1e-6, "stopping distance v^2/(2 mu g)");
        check_below(std::abs(e.friction / (mu * mass * gravity * way) - 1.),
                    1e-5,
                    "dissipates mu m g d");
        check_below(e.imbalance(), 1e-4, "the ledger closes");
      }
  }



  // The cube: 10 mm, pressed by 100 N.
  constexpr double side = .01, young = 16e9, force = 100., floor_speed = .12;

  SceneParameters
  cube(const double stiffness_damping = 0.)
  {
    SceneParameters s =
      block_on_floor({{side, side, side}}, {{10, 10, 10}}, young, force);
    SupportParameters top;
    top.name       = "top";
    top.body       = "block";
    top.face       = "z_max";
    top.kind       = SupportParameters::Kind::components;
    top.components = {"x", "y"};
    s.supports.push_back(top);
    s.damping.stiffness_damping = stiffness_damping;
    return s;
  }

  TransientDrive
  pressed_drive(const double mu)
  {
    TransientDrive d = steady_drive(mu, floor_speed);
    d.load           = [](const double t) { return std::min(1., t / 5e-6); };
    return d;
  }

  /** Starts with the open cube on the floor and runs to @p end; @p look at
   * every step. */
  template <typename Look>
  void
  start_floor(TransientIntegrator       &run,
              const ReducedContactModel &model,
              const double               end,
              const Look                &look)
  {
    const Eigen::VectorXd q = Eigen::VectorXd::Zero(model.n_modes());
    run.start(q, q, Eigen::VectorXd::Zero(3 * model.n_nodes()));
    while (run.time() < end)
      {
        run.advance();
        look();
      }
  }

  /** Sum of the nodal forces: normal, along, across. */
  Eigen::Vector3d
  resultant(const TransientIntegrator &run)
  {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (Eigen::Index i = 0; i < run.forces().size(); i += 3)
      sum += run.forces().segment<3>(i);
    return sum;
  }

  /** The largest |F_t| before the first reflection comes back, over
   * sqrt(rho G) A V. */
  double
  highest_force(const std::string   &name,
                const Reduced       &r,
                TransientIntegrator &run,
                const double         dt)
  {
    const double G = young / 2.6, arrival = 2. * side / std::sqrt(G / 2500.),
                 bound = std::sqrt(2500. * G) * side * side * floor_speed;
    Worst        normal;
    double       highest = 0., at = 0., chatter = 0., last = 0.;
    unsigned int n = 0, n_stick = 0;
    check(std::abs(bound - 47.07) < .01 && std::abs(arrival - 12.75e-6) < 1e-8,
          "the published bound and time");
    start_floor(run, r.model, 12.7e-6 - .5 * dt, [&]() {
      const Eigen::Vector3d F   = resultant(run);
      const double          F_t = F.tail<2>().norm();
      if (F_t > highest)
        {
          highest = F_t;
          at      = run.time();
        }
      normal.add(F[0]);
      chatter += std::abs(F_t - last);
      last = F_t;
      ++n;
      for (const auto status : run.status())
        n_stick += status == ContactStatus::stick;
    });
    std::printf(
      "%s, dt %.2e: highest F_t %.4f N = %.4f of the bound at %.2e s, "
      "F_n up to %.2f N, way up and down %.2f N, %.1f nodes stick, "
      "ledger %.1e\n",
      name.c_str(),
      dt,
      highest,
      highest / bound,
      at,
      normal.largest(),
      chatter,
      double(n_stick) / n,
      run.ledger().imbalance());
    return highest / bound;
  }

  /** All unknowns keep the bound; modes up to a cut-off do where they are
   * enough to carry the wave that starts at once and do not ring at their end.
   */
  void
  impedance()
  {
    double before = 1e300, damped_before = 1e300;
    for (const double cut_off : {100e3, 150e3, 200e3, 250e3, 290e3})
      {
        const Reduced r(cube(), cut_off, 0., false, 1);
        const double  nodal = force / r.model.n_nodes();
        if (before == 1e300)
          for (const double dt : {1e-6, 2e-7, 5e-8})
            {
              ImplicitTransient run(
                full_model(r), dt, pressed_drive(.5), nodal);
              check_below(highest_force("implicit", r, run, dt),
                          1.,
                          "implicit, " + number(dt) +
                            " s: |F_t| <= sqrt(rho G) A V");
            }
        const double     dt = 2e-7;
        ReducedTransient run(r.model, dt, pressed_drive(.5), nodal);
        const double     share =
          highest_force(number(r.model.n_modes()) + " modes", r, run, dt);
        if (before > 1.1)
          check_below(share, before, "more modes carry more of the wave");
        else
          check_below(share, 1.01, "44 modes and more: the bound to 1 %");
        before                     = share;
        ReducedContactModel damped = r.model;
        add_cut_off_damping(damped, .2);
        ReducedTransient damped_run(damped, dt, pressed_drive(.5), nodal);
        const double     damped_share = highest_force(
          number(r.model.n_modes()) + " modes, damped", r, damped_run, dt);
        if (damped_before > 1.)
          check_below(damped_share, damped_before, "damped: more modes");
        else
          check_below(damped_share, 1., "damped: |F_t| <= sqrt(rho G) A V");
        damped_before = damped_share;
      }
  }

  /** The pressed cube comes to steady sliding. */
  void
  steady()
  {
    const double        mu = .3, dt = 1e-6;
    const Reduced       r(cube(2e-7), 100e3, 0., false, 1);
    const SteadySliding s = steady_sliding(r.model, mu);
    std::printf("steady: %u of %u closed\n", s.n_closed(), r.model.n_nodes());
    check_below(std::abs(s.resultant()[1] / s.resultant()[0] - mu),
                1e-9,
                "steady sliding: F_t/F_n");
    check(r.model.n_nodes() == 121, "121 nodes");
    for (const bool is_reduced : {true, false})
      {
        std::unique_ptr<TransientIntegrator> run;
        if (is_reduced)
          run = std::make_unique<ReducedTransient>(
            r.model, dt, pressed_drive(mu), force / r.model.n_nodes());
        else
          run = std::make_unique<ImplicitTransient>(
            full_model(r), dt, pressed_drive(mu), force / r.model.n_nodes());
        const std::string name = is_reduced ? "reduced" : "implicit";
        Worst             closed;
        start_floor(*run, r.model, 2e-3, [&]() {
          const auto        &status   = run->status();
          const unsigned int n_closed = static_cast<unsigned int>(
            121 -
            std::count(status.begin(), status.end(), ContactStatus::open));
          if (run->time() > .5e-3 && run->time() < 1e-3)
            {
              closed.add(n_closed);
            }
        });
        const Eigen::Vector3d F = resultant(*run);
        std::printf("%s: %.0f to %.0f closed from 0.5 to 1 ms; at the end F_n "
                    "%.5f, F_t/F_n %.8f, ledger %.1e\n",
                    name.c_str(),
                    closed.smallest(),
                    closed.largest(),
                    F[0],
                    F[1] / F[0],
                    run->ledger().imbalance());
        check(run->status() == s.status,
              name + ": ends with the contact state of steady sliding");
        check_below(std::abs(F[1] / F[0] - mu), 1e-5, name + ": F_t/F_n");
        check_below(std::abs(F[2] / F[0]), 1e-9, name + ": nothing across");
      }
  }
} // namespace

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const std::string                        which = argc > 1 ? argv[1] : "";
  if (which == "rest")
    sliding_to_rest();
  else if (which == "impedance")
    impedance();
  else if (which == "steady")
    steady();
  else
    check(false, "an argument: rest, impedance or steady");
}
