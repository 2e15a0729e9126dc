// SPDX-License-Identifier: LGPL-2.1-or-later

// The coarse brake on its modes with a massless contact interface: steady
// sliding, its linearisation beside the eigenvalue analysis of the whole model,
// and growth in time.

#include "transient/pressed_brake.h"
#include "worst.h"

#include <squeal/base/exceptions.h>
#include <squeal/transient/modal_step.h>
#include <squeal/transient/reduced_transient.h>
#include <squeal/transient/run_in.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  using Complex = std::complex<double>;

  void
  steady()
  {
    for (const double mu : {0., .2, .5})
      {
        const Reduced         few(pressed_brake(mu), 15e3);
        const Reduced         many(pressed_brake(mu), 40e3);
        const SteadySliding   a   = steady_sliding(few.model, mu);
        const SteadySliding   b   = steady_sliding(many.model, mu);
        const Eigen::Vector3d sum = a.resultant();
        const std::string     at  = "mu = " + number(mu) + ": ";
        check_below(std::abs(sum[0] - load) / load,
                    1e-9,
                    at + "the contact carries the load");
        check_below(std::abs(sum[1] - mu * sum[0]) / load,
                    1e-9,
                    at + "friction is mu times it");
        check_below(std::abs(sum[2]) / load, 1e-9, at + "none across");
        check_below(
          (a.forces - b.forces).cwiseAbs().maxCoeff<Eigen::PropagateNaN>() /
            a.forces.maxCoeff<Eigen::PropagateNaN>(),
          1e-6,
          at + "statics do not depend on the cut-off");
        check(a.forces.minCoeff<Eigen::PropagateNaN>() >= -1e-9 * load,
              at + "no tension");
        std::printf("mu %g: %u of %u nodes closed, %u iterations\n",
                    mu,
                    a.n_closed(),
                    few.model.n_nodes(),
                    a.report.iterations);
      }
  }

  double
  largest(const Eigen::MatrixXd &x)
  {
    return x.cwiseAbs().maxCoeff<Eigen::PropagateNaN>();
  }

  /** What contact states are computed with: a third of the flexibility, and the
   * model of the other direction of sliding. */
  void
  states_of_sliding()
  {
    const double  mu = .5;
    const Reduced r(pressed_brake(mu), 5e3), back(pressed_brake(-mu), 5e3);
    const SteadySliding forward  = steady_sliding(r.model, mu),
                        backward = steady_sliding(back.model, mu);
    check(largest(forward.forces - backward.forces) > 1e-3 * load,
          "forces forward and backward differ");

    ReducedContactModel turned = r.model;
    turned.turn_back(back.nodes.turned_back_from(r.nodes));
    check_below(largest(turned.flexibility - back.model.flexibility) /
                  largest(back.model.flexibility),
                1e-10,
                "turned back, the flexibility is that of the other direction");
    const SteadySliding other = steady_sliding(turned, mu);
    check_below(largest(other.forces - backward.forces) / load,
                1e-9,
                "and so are the forces");
    check(other.status == backward.status, "and the states");

    const ReducedContactModel of_sliding = reduce_contact_model(
      r.pencil,
      r.basis,
      5e3,
      r.nodes,
      r.separated.restrict_forces(load_vector(
        r.discretization, PointEvaluator(r.discretization), r.scene.loads[0])),
      {},
      Flexibility::of_sliding);
    const SteadySliding states = steady_sliding(of_sliding, mu);
    check_below(largest(states.forces - forward.forces) / load,
                1e-7,
                "the flexibility of sliding gives the same forces");
    check(states.status == forward.status, "and states");
  }

  void
  run_in()
  {
    const double mu = .5;
    Reduced      r(pressed_brake(mu), 15e3);
    const auto  &areas = r.separated.contacts[0].areas;
    check(steady_sliding(r.model, mu).n_closed() < r.model.n_nodes(),
          "the trailing edge of a flat pad is open");
    r.model.initial_gap = worn_gap(
      r.model, areas, Eigen::VectorXd::Constant(r.model.n_nodes(), mu));
    const SteadySliding worn = steady_sliding(r.model, mu);
    check(worn.n_closed() == r.model.n_nodes(), "that of a worn one is not");
    Eigen::VectorXd wear(r.model.n_nodes());
    for (unsigned int j = 0; j < r.model.n_nodes(); ++j)
      wear[j] = worn.forces[3 * j] / areas[j] * r.model.speed_ratio[j];
    check_below(
      (wear.array() - wear.mean()).abs().maxCoeff<Eigen::PropagateNaN>() /
        wear.mean(),
      1e-6,
      "the wear is the same everywhere");
    // Three more times the depth that it has.
    r.model.initial_gap +=
      3. * wear / wear.mean() *
      (r.model.initial_gap.maxCoeff<Eigen::PropagateNaN>() -
       r.model.initial_gap.minCoeff<Eigen::PropagateNaN>());
    const SteadySliding later = steady_sliding(r.model, mu);
    check_below(
      (later.forces - worn.forces).cwiseAbs().maxCoeff<Eigen::PropagateNaN>() /
        worn.forces.maxCoeff<Eigen::PropagateNaN>(),
      1e-6,
      "and further wear leaves the forces as they are");
  }

  void
  stable_step()
  {
    // A free mass of 1 kg on the stiffness 1/G of the contact: Newmark's method
    // with beta = 1/6.
    const double        G = 1e-8;
    ReducedContactModel one;
    one.omega_squared = one.damping = Eigen::VectorXd::Zero(1);
    one.participation               = Eigen::Vector3d(1., 0., 0.);
    one.flexibility                 = G * Eigen::Matrix3d::Identity();
    one.initial_gap                 = Eigen::VectorXd::Zero(1);
    one.load                        = Eigen::VectorXd::Zero(1);
    const double limit              = 2. * std::sqrt(3. * G);
    check_below(std::abs(largest_stable_step(one, 1.) / limit - 1.),
                .02,
                "omega dt = 2 sqrt(3)");

    const Reduced massless(pressed_brake(.5), 24e3);
    check(is_stable_step(massless.model, 1e-5),
          "a contact without mass is quiet at long steps");
    const Reduced r(pressed_brake(.5), 24e3, 120e3);
    const double  largest = largest_stable_step(r.model, 1e-5);
    std::printf("largest stable step %g s\n", largest);
    check(largest < 1e-5 && largest > 1e-7, "one with mass is not");
    TransientDrive drive;
    drive.friction = [](double) { return .5; };
    drive.speed    = [](double) { return speed; };
    drive.load     = [](double) { return 1.; };
    bool refused   = false;
    try
      {
        ReducedTransient run(
          r.model, 1.1 * largest, drive, load / r.model.n_nodes());
      }
    catch (const InputError &error)
      {
        refused = std::string(error.what()).find("largest stable step") !=
                  std::string::npos;
      }
    check(refused, "a longer step is refused with the largest allowed");
    ReducedTransient run(
      r.model, .99 * largest, drive, load / r.model.n_nodes());
    const SteadySliding s = steady_sliding(r.model, .5);
    run.start(s.coordinates,
              Eigen::VectorXd::Constant(r.model.n_modes(), 1e-9),
              s.forces);
    for (unsigned int i = 0; i < 500; ++i)
      run.advance();
    check_below(
      (run.forces() - s.forces).cwiseAbs().maxCoeff<Eigen::PropagateNaN>(),
      1e-4 * load,
      "below it a disturbance stays small");
  }

  void
  linearization()
  {
    const double mu     = .4;
    double       before = 0.;
    for (const double cut_off : {12e3, 40e3})
      {
        const Reduced          r(pressed_brake(mu), cut_off);
        const SteadySliding    s       = steady_sliding(r.model, mu);
        const LinearizedMotion reduced = linearize(r.model, s, mu, speed);
        const Eigen::VectorXcd whole   = whole_model(r, s);
        check(whole.size() > 8, "pairs in the band");
        Worst worst;
        for (const Complex &l : whole)
          {
            const double d = distance(reduced.lambda, l);
            worst.add(d);
            std::printf(
              "  %.3f Hz %.4f: %.2e\n", l.imag() / (2 * M_PI), l.real(), d);
          }
        std::printf("cut-off %g: worst %.3e, %u closed\n",
                    cut_off,
                    worst.largest(),
                    s.n_closed());
        if (before > 0.)
          check_below(worst.largest(),
                      .5 * before,
                      "the reduction converges with its cut-off");
        before = worst.largest();
      }
    check_below(before, 1e-3, "eigenvalues of the whole model");
  }

  void
  growth()
  {
    const double    mu            = .5;
    SceneParameters scene         = pressed_brake(mu);
    scene.bodies[1].young_modulus = 1.6e10;
    const Reduced          r(scene, 24e3);
    const SteadySliding    s      = steady_sliding(r.model, mu);
    const LinearizedMotion linear = linearize(r.model, s, mu, speed);
    Eigen::Index           worst;
    linear.lambda.real().maxCoeff(&worst);
    const Complex lambda = linear.lambda[worst];
    std::printf("fastest: %.3f Hz, %.3f 1/s\n",
                lambda.imag() / (2 * M_PI),
                lambda.real());
    check(lambda.real() > 20., "an unstable pair");
    for (const double dt : {4e-6, 2e-6})
      {
        TransientDrive drive;
        drive.friction = [mu](double) { return mu; };
        drive.speed    = [](double) { return speed; };
        drive.load     = [](double) { return 1.; };
        ReducedTransient run(r.model, dt, drive, load / r.model.n_nodes());
        Eigen::VectorXd  v = Eigen::VectorXd::Zero(r.model.n_modes());
        v.setConstant(1e-9);
        run.start(s.coordinates, v, s.forces);
        const double        end = 6. / lambda.real();
        std::vector<double> logs, phases, times;
        unsigned int        iterations = 0, n = 0;
        const auto          begin = std::chrono::steady_clock::now();
        while (run.time() < end)
          {
            iterations += run.advance().iterations;
            ++n;
            const Complex a = linear.amplitudes(
              s, run.coordinates(), run.velocities(), run.forces())[worst];
            times.push_back(run.time());
            logs.push_back(std::log(std::abs(a)));
            phases.push_back(std::arg(a));
          }
        const double seconds = std::chrono::duration<double>(
                                 std::chrono::steady_clock::now() - begin)
                                 .count();
        const std::size_t a = logs.size() / 3, b = logs.size() - 1;
        const double      rate  = (logs[b] - logs[a]) / (times[b] - times[a]);
        double            turns = 0.;
        for (std::size_t k = a; k < b; ++k)
          turns += std::remainder(phases[k + 1] - phases[k], 2 * M_PI);
        const double f = turns / (2 * M_PI) / (times[b] - times[a]);
        std::printf("dt %g: rate %.4f (%.4f), f %.4f (%.4f), imbalance %.2e, "
                    "%.2f iterations a step, %.0f steps/s\n",
                    dt,
                    rate,
                    lambda.real(),
                    f,
                    lambda.imag() / (2 * M_PI),
                    run.ledger().imbalance(),
                    double(iterations) / n,
                    n / seconds);
        check_below(std::abs(rate - lambda.real()),
                    std::max(.02 * lambda.real(), 3.),
                    "growth rate");
        check_below(
          std::abs(f / lambda.imag() * 2 * M_PI - 1.), 2e-3, "frequency");
        check_below(run.ledger().imbalance(), 1e-3, "the ledger closes");
      }
  }

  /** The pad thrown off the disc, which falls back on it again and again. */
  void
  impacts()
  {
    const Reduced       r(pressed_brake(.3), 24e3);
    const SteadySliding s      = steady_sliding(r.model, .3);
    double              before = 0.;
    for (const double dt : {4e-6, 1e-6})
      {
        TransientDrive drive;
        drive.friction = [](double) { return .3; };
        drive.speed    = [](double) { return speed; };
        drive.load     = [](double) { return 1.; };
        ReducedTransient run(r.model, dt, drive, load / r.model.n_nodes());
        // Against the load; the fastest mode with 2 cm/s at unit modal mass.
        Eigen::VectorXd v = -r.model.load;
        v *= 2e-2 / v.cwiseAbs().maxCoeff<Eigen::PropagateNaN>();
        run.start(s.coordinates, v, s.forces);
        unsigned int n_flights = 0, n_steps = 0, n_sweeps = 0;
        bool         flies = false;
        Worst        highest;
        const double start = run.ledger().start;
        while (run.time() < 10e-3)
          {
            n_sweeps += run.advance().sweeps;
            ++n_steps;
            const bool all_open = std::all_of(
              run.status().begin(), run.status().end(), [](const auto c) {
                return c == ContactStatus::open;
              });
            n_flights += all_open && !flies;
            flies         = all_open;
            const auto &e = run.ledger();
            highest.add((e.kinetic + e.elastic + e.damping + e.friction -
                         e.driving - e.load) /
                        start);
          }
        std::printf("dt %g: %u flights, imbalance %.2e, numerical %.2e of "
                    "%.3e J, gain %.2e, %u sweeps in %u steps\n",
                    dt,
                    n_flights,
                    run.ledger().imbalance(),
                    run.ledger().numerical / start,
                    start,
                    highest.largest() - 1.,
                    n_sweeps,
                    n_steps);
        check(n_flights >= 3, "the contact opens as a whole, many times");
        check_below(run.ledger().imbalance(), 1e-3, "the ledger closes");
        const double gain = highest.largest() - 1.;
        if (before > 0.)
          check_below(gain,
                      before / 8.,
                      "what impacts make falls with the square of the step");
        before = gain;
      }
  }
} // namespace

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const std::string                        which = argc > 1 ? argv[1] : "";
  if (which == "steady")
    steady();
  else if (which == "states_of_sliding")
    states_of_sliding();
  else if (which == "linearization")
    linearization();
  else if (which == "growth")
    growth();
  else if (which == "impacts")
    impacts();
  else if (which == "run_in")
    run_in();
  else if (which == "stable_step")
    stable_step();
  else
    check(false,
          "an argument: steady, states_of_sliding, linearization, growth, "
          "impacts, run_in or stable_step");
}
