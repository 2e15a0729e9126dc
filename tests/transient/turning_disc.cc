// SPDX-License-Identifier: LGPL-2.1-or-later

// A brake whose disc turns with its mesh beside the same brake with a disc that
// stands still and slides: statics at several angles, a ramp in time with its
// energies and a restart, and what a feature of the disc does.

#include "transient/pressed_brake.h"

#include <squeal/contact/turning_contact.h>
#include <squeal/transient/explicit_transient.h>
#include <squeal/transient/implicit_transient.h>

#include <deal.II/base/mpi.h>

#include <chrono>
#include <cmath>
#include <cstdio>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  constexpr double mu = .3, fast = 20.; // m/s

  SceneParameters
  turning_brake(const std::array<unsigned int, 3> &disc, const unsigned int pad)
  {
    SceneParameters s = pressed_brake(mu);
    s.bodies[0].cells = disc;
    s.bodies[1].cells = {{pad, pad, 2}};
    s.bodies[2].cells = {{pad, pad, 4}};
    s.contacts[0].friction_direction =
      ContactParameters::FrictionDirection::slip;
    s.contacts[0].sliding_speed = fast;
    return s;
  }

  std::shared_ptr<TurningContact>
  turning_contact(const Reduced &r, const unsigned int knots_per_cell)
  {
    return std::make_shared<TurningContact>(r.discretization,
                                            r.scene.contacts[0],
                                            r.separated.contacts[0],
                                            r.separated.reduce,
                                            knots_per_cell);
  }

  TransientDrive
  drive(const double ramp_time)
  {
    TransientDrive d;
    d.friction = [](double) { return mu; };
    d.speed    = [](double) { return fast; };
    d.load     = [ramp_time](const double t) {
      return t < ramp_time ? .5 * (1. - std::cos(M_PI * t / ramp_time)) : 1.;
    };
    return d;
  }



  /** Steady sliding with the disc at an angle: the sink of the load, m, and
   * the nodal forces. */
  struct Static
  {
    double          sink;
    Eigen::VectorXd forces;
  };

  Static
  press(const Reduced &r, TurningContact &turning, const double angle)
  {
    FullContactModel full     = full_model(r);
    full.relative_motion      = turning.relative_motion(angle);
    const auto          model = reduce_contact_model(r.pencil,
                                            r.basis,
                                            r.model.cut_off,
                                            turning.geometry(angle),
                                            Block(full.load));
    const SteadySliding s     = steady_sliding(model, mu);
    const auto          sum   = s.resultant();
    check_close(sum[0], load, 1e-9, "the pad carries the load");
    check_close(sum[1], mu * load, 1e-9, "and its friction");
    return {full.load.dot(static_motion(full, s.coordinates, 1., s.forces)) /
              load,
            s.forces};
  }

  void
  statics()
  {
    std::vector<double> errors, force_errors;
    for (const unsigned int n : {1, 2, 3})
      {
        const Reduced r(turning_brake({{16 * n, 3 * n, 1}}, 2 * n), 12e3);
        const auto    turning = turning_contact(r, 0);
        const double  pitch   = 2. * M_PI / (16 * n);
        const Static  still   = press(r, *turning, 0.);
        const Static  whole   = press(r, *turning, 3. * pitch);
        check_below(std::abs(whole.sink / still.sink - 1.),
                    1e-9,
                    "a turn by whole cells: the sink of the load");
        check_below((whole.forces - still.forces).norm() / still.forces.norm(),
                    1e-6,
                    "a turn by whole cells: the nodal forces");
        double sink = 0., forces = 0.;
        for (const double share : {.17, .35, .5, .71})
          {
            const Static s = press(r, *turning, (2. + share) * pitch);
            sink           = std::max(sink, std::abs(s.sink / still.sink - 1.));
            forces         = std::max(
              forces, (s.forces - still.forces).norm() / still.forces.norm());
          }
        std::printf("disc of %u cells: sink %.3e m, changes by %.2e with the "
                    "angle, nodal forces by %.2e\n",
                    16 * n,
                    still.sink,
                    sink,
                    forces);
        errors.push_back(sink);
        force_errors.push_back(forces);
      }
  }



  struct Course
  {
    std::vector<double> normal, tangential;
    double              imbalance, steps_per_second;
    EnergyLedger        ledger;
  };

  Course
  run(ExplicitTransient &motion,
      const Reduced     &r,
      const double       end,
      const double       dt)
  {
    Course     result;
    const auto begin = std::chrono::steady_clock::now();
    motion.start(Eigen::VectorXd::Zero(r.model.n_modes()),
                 Eigen::VectorXd::Zero(r.model.n_modes()),
                 Eigen::VectorXd::Zero(3 * r.model.n_nodes()));
    unsigned int n = 0;
    while (motion.time() < end)
      {
        motion.advance();
        if (motion.time() >= result.normal.size() * dt)
          {
            double normal = 0., tangential = 0.;
            for (unsigned int j = 0; j < r.model.n_nodes(); ++j)
              {
                normal += motion.forces()[3 * j];
                tangential += motion.forces()[3 * j + 1];
              }
            result.normal.push_back(normal);
            result.tangential.push_back(tangential);
          }
        ++n;
      }
    result.ledger           = motion.ledger();
    result.imbalance        = motion.ledger().imbalance();
    result.steps_per_second = n / std::chrono::duration<double>(
                                    std::chrono::steady_clock::now() - begin)
                                    .count();
    return result;
  }

  double
  rms_difference(const std::vector<double> &a, const std::vector<double> &b)
  {
    double sum = 0.;
    for (std::size_t i = 0; i < a.size(); ++i)
      sum += std::pow(a[i] - b[i], 2);
    return std::sqrt(sum / a.size());
  }

  double
  stable_step(const Reduced &r)
  {
    const auto            pencil = std::make_shared<const Pencil>(r.pencil);
    Block                 ones   = Block::Ones(r.pencil.space()->n_owned(), 1);
    const Eigen::VectorXd mass   = r.pencil.multiply_mass(ones);
    return .9 * critical_step(largest_frequency(*pencil, mass),
                              r.scene.damping.mass_damping,
                              r.scene.damping.stiffness_damping,
                              .5);
  }

  void
  agreement()
  {
    const double end = 2e-3;
    for (const unsigned int n : {1, 2})
      {
        SceneParameters  scene = turning_brake({{16 * n, 3 * n, 1}}, 2);
        const Reduced    r(scene, 12e3, 0., true);
        const double     dt    = stable_step(r);
        FullContactModel still = full_model(r), turning = still;
        turning.turning = turning_contact(r, 1000);
        ExplicitTransient eulerian(
          still, dt, drive(5e-4), load / r.model.n_nodes()),
          corotating(turning, dt, drive(5e-4), load / r.model.n_nodes());
        const Course a      = run(eulerian, r, end, 1e-5),
                     b      = run(corotating, r, end, 1e-5);
        const double normal = rms_difference(a.normal, b.normal) / load,
                     tangential =
                       rms_difference(a.tangential, b.tangential) / (mu * load);
        std::printf(
          "disc of %u cells, %u unknowns, dt %.3g s, turned by %.2f cells: rms "
          "difference normal %.2e, tangential %.2e; ledger %.1e and %.1e; "
          "driving %.4e and %.4e J, friction %.4e and %.4e J; %.0f and %.0f "
          "steps/s; %u pairs tried\n",
          16 * n,
          r.pencil.space()->n_global(),
          dt,
          fast * end / .1075 / (2 * M_PI / (16 * n)),
          normal,
          tangential,
          a.imbalance,
          b.imbalance,
          a.ledger.driving,
          b.ledger.driving,
          a.ledger.friction,
          b.ledger.friction,
          a.steps_per_second,
          b.steps_per_second,
          turning.turning->mortar().n_pairs_tried());
      }
  }



  /** A continued run against one that was not stopped. */
  void
  restart()
  {
    const Reduced r(turning_brake({{16, 3, 1}}, 2), 12e3, 0., true, 1);
    const double  dt = stable_step(r), h = dt / .9 * .5;
    const auto    explicit_run = [&]() -> std::unique_ptr<TransientIntegrator> {
      FullContactModel m = full_model(r);
      m.turning          = turning_contact(r, 20);
      return std::make_unique<ExplicitTransient>(
        m, h, drive(1e-4), load / r.model.n_nodes());
    };
    const auto implicit_run = [&]() -> std::unique_ptr<TransientIntegrator> {
      FullContactModel m = full_model(r);
      m.turning          = turning_contact(r, 20);
      return std::make_unique<ImplicitTransient>(
        m, 4e-6, drive(1e-4), load / r.model.n_nodes());
    };
    const auto compare = [&](const auto &make, const std::string &name) {
      const auto start = [&](TransientIntegrator &run) {
        run.start(Eigen::VectorXd::Zero(r.model.n_modes()),
                  Eigen::VectorXd::Zero(r.model.n_modes()),
                  Eigen::VectorXd::Zero(3 * r.model.n_nodes()));
      };
      const auto whole = make(), second = make();
      start(*whole);
      for (unsigned int i = 0; i < 500; ++i)
        whole->advance();
      const std::vector<double> memory = whole->memory();
      for (unsigned int i = 0; i < 500; ++i)
        whole->advance();
      start(*second);
      second->restore(memory);
      for (unsigned int i = 0; i < 500; ++i)
        second->advance();
      check(whole->memory() == second->memory(),
            name + ": a continued run gives the same bits");
      check(whole->forces().norm() > 1., name + ": the pad is pressed on");
    };
    compare(explicit_run, "explicit");
    compare(implicit_run, "implicit");
  }



  /** Amplitudes of the normal force at the first @p n harmonics of the last of
   * @p turns turns, N. */
  std::vector<double>
  harmonics(const SceneParameters &scene,
            const double           turns,
            const unsigned int     n,
            double                &imbalance)
  {
    const Reduced       r(scene, 12e3, 0., true, 1);
    const double        period = 2. * M_PI * .1075 / fast;
    const SteadySliding steady = steady_sliding(r.model, mu);
    FullContactModel    full   = full_model(r);
    full.turning               = turning_contact(r, 100);
    ExplicitTransient run(
      full, stable_step(r), drive(0.), load / r.model.n_nodes());
    run.start(steady.coordinates,
              Eigen::VectorXd::Zero(r.model.n_modes()),
              steady.forces);
    std::vector<std::complex<double>> sums(n);
    unsigned int                      n_samples = 0, n_steps = 0;
    const auto                        begin = std::chrono::steady_clock::now();
    while (run.time() < turns * period)
      {
        run.advance();
        ++n_steps;
        if (run.time() < (turns - 1.) * period)
          continue;
        double force = 0.;
        for (unsigned int j = 0; j < r.model.n_nodes(); ++j)
          force += run.forces()[3 * j];
        for (unsigned int k = 0; k < n; ++k)
          sums[k] +=
            force * std::polar(1., -2. * M_PI * k * run.time() / period);
        ++n_samples;
      }
    imbalance = run.ledger().imbalance();
    std::vector<double> result;
    for (const auto &sum : sums)
      result.push_back((result.empty() ? 1. : 2.) * std::abs(sum) / n_samples);
    std::printf("%u steps, %.0f steps/s, imbalance %.1e, harmonics",
                n_steps,
                n_steps / std::chrono::duration<double>(
                            std::chrono::steady_clock::now() - begin)
                            .count(),
                imbalance);
    for (const double x : result)
      std::printf(" %.2e", x);
    std::printf(" N\n");
    return result;
  }

  void
  feature()
  {
    SceneParameters  scene = turning_brake({{16, 3, 1}}, 2);
    double           imbalance;
    const auto       without = harmonics(scene, 1.5, 17, imbalance);
    SpringParameters spring;
    spring.name        = "rib";
    spring.body        = "disc";
    spring.first_point = {{-.12, 0., 0.}};
    spring.last_point  = spring.first_point;
    spring.direction   = {{0., 0., 1.}};
    spring.stiffness   = 2e7;
    scene.springs.push_back(spring);
    const auto with = harmonics(scene, 1.5, 17, imbalance);
    check(with[1] > 1e2 * without[1], "a rib shows once a turn");
  }
} // namespace

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const std::string                        which = argc > 1 ? argv[1] : "";
  if (which == "statics")
    statics();
  else if (which == "agreement")
    agreement();
  else if (which == "restart")
    restart();
  else if (which == "feature")
    feature();
  else
    check(false, "an argument: statics, agreement, restart or feature");
}
