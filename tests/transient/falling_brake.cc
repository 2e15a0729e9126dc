// SPDX-License-Identifier: LGPL-2.1-or-later

// A brake with friction that falls with the slip rate: what the slope adds to
// its growth in time and to its eigenvalue; a constant law and restarts bit by
// bit.

#include "transient/hand_made.h"
#include "transient/pressed_brake.h"

#include <squeal/transient/growth.h>
#include <squeal/transient/implicit_transient.h>
#include <squeal/transient/reduced_transient.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  using Complex = std::complex<double>;

  /** The brake with the coefficient .5 at its speed, or a law that falls there
   * by @p slope, s/m. */
  SceneParameters
  falling_brake(const double slope)
  {
    SceneParameters scene         = pressed_brake(.5);
    scene.bodies[1].young_modulus = 1.6e10;
    auto &pair                    = scene.contacts[0];
    if (slope == 0.)
      return scene;
    const double excess       = -slope * speed;
    pair.friction_law         = ContactParameters::FrictionLaw::exponential;
    pair.decay_speed          = speed;
    pair.friction_coefficient = .5 - excess;
    pair.static_friction_coefficient = .5 - excess + excess * std::exp(1.);
    return scene;
  }

  /** Of the fastest pair near 5 kHz: of the whole model, of the linearised
   * motion, and in time for each step; 1/s. */
  struct Growth
  {
    double              whole, linear;
    std::vector<double> in_time;
  };

  Growth
  brake_growth(const double slope, const std::vector<double> &steps)
  {
    const Reduced       r(falling_brake(slope), 24e3);
    const auto         &pair = r.scene.contacts[0];
    const NodalFriction f =
      FrictionLaw(pair).in_sliding(r.model.speed_ratio, speed);
    check_below(std::abs(f.slope[0] - slope), 1e-12, "slope of the law");
    const SteadySliding    s      = steady_sliding(r.model, f.coefficient);
    const LinearizedMotion linear = linearize(r.model, s, f, speed);
    const Eigen::VectorXcd all    = whole_model(r, s);
    Eigen::Index           k, whole;
    all.real().maxCoeff(&whole);
    (linear.lambda.array() - all[whole]).abs().minCoeff(&k);
    Growth g{all[whole].real(), linear.lambda[k].real(), {}};
    for (const double dt : steps)
      {
        ReducedTransient run(
          r.model, dt, drive_by(pair, speed), load / r.model.n_nodes());
        // So large that what the tolerance of the steps leaves is small beside
        // the slope's share of the rate.
        run.start(s.coordinates,
                  Eigen::VectorXd::Constant(r.model.n_modes(), 1e-8),
                  s.forces);
        std::vector<double>  times;
        std::vector<Complex> amplitudes;
        bool                 same_status = true;
        while (run.time() < 6. / g.linear)
          {
            run.advance();
            same_status = same_status && run.status() == s.status;
            if (run.time() >= times.size() * 2e-5)
              {
                times.push_back(run.time());
                amplitudes.push_back(linear.amplitudes(
                  s, run.coordinates(), run.velocities(), run.forces())[k]);
              }
          }
        check(same_status, "the contact state stays");
        check_below(run.ledger().imbalance(), 1e-3, "the ledger closes");
        const auto window = fit_window(amplitudes, 0, amplitudes.size(), false);
        g.in_time.push_back(
          fit_growth(times, amplitudes, window.first, window.second).rate);
        std::printf("brake, slope %g, dt %g: %.4f 1/s, linearised %.4f, whole "
                    "model %.4f\n",
                    slope,
                    dt,
                    g.in_time.back(),
                    g.linear,
                    g.whole);
      }
    return g;
  }

  /** What the slope adds to the growth of a brake. */
  void
  growing_brake()
  {
    const std::vector<double> steps = {4e-6, 2e-6};
    const Growth              flat  = brake_growth(0., steps),
                 falling            = brake_growth(-.02, steps);
    const double added              = falling.linear - flat.linear;
    check(added > 3., "a falling law adds to the growth rate");
    std::printf("added: linearised %.4f, whole %.4f, in time %.4f, %.4f 1/s\n",
                added,
                falling.whole - flat.whole,
                falling.in_time[0] - flat.in_time[0],
                falling.in_time[1] - flat.in_time[1]);
    check_below(std::abs((falling.whole - flat.whole) / added - 1.),
                .05,
                "by as much in the whole model");
    for (unsigned int i = 0; i < steps.size(); ++i)
      {
        check_below(
          std::abs((falling.in_time[i] - flat.in_time[i]) / added - 1.),
          .05,
          "by as much in time");
        check_below(std::abs(falling.in_time[i] / falling.linear - 1.),
                    .02,
                    "growth rate in time");
      }
  }



  bool
  same_bits(const TransientIntegrator &a, const TransientIntegrator &b)
  {
    return a.forces() == b.forces() && a.motion() == b.motion() &&
           a.coordinates() == b.coordinates() && a.status() == b.status();
  }

  /** A constant law by either way, and a restart in the middle. */
  void
  bits()
  {
    const Reduced     r(falling_brake(-.02), 24e3);
    ContactParameters constant;
    constant.friction_coefficient = .5;
    const SteadySliding s         = steady_sliding(r.model, .5);
    const auto          start     = [&](TransientIntegrator &run) {
      // Against the load, so that nodes stick, slip and open.
      Eigen::VectorXd v = -r.model.load;
      v *= 2e-2 / v.cwiseAbs().maxCoeff<Eigen::PropagateNaN>();
      run.start(s.coordinates, v, s.forces);
    };
    const double     dt = 2e-6, force = load / r.model.n_nodes();
    ReducedTransient by_number(r.model, dt, steady_drive(.5, speed), force),
      by_law(r.model, dt, drive_by(constant, speed), force);
    start(by_number);
    start(by_law);
    std::array<unsigned int, 3> n{};
    for (unsigned int i = 0; i < 800; ++i)
      {
        by_number.advance();
        by_law.advance();
        for (const auto status : by_number.status())
          ++n[static_cast<unsigned int>(status)];
      }
    std::printf("constant law: %u, %u, %u\n", n[0], n[1], n[2]);
    check(*std::min_element(n.begin(), n.end()) > 0,
          "nodes open, stick and slip");
    check(same_bits(by_number, by_law), "a constant law: the same bits");
    check(by_number.memory() == by_law.memory(), "and the same memory");

    const TransientDrive falls = drive_by(r.scene.contacts[0], speed);
    for (const bool is_reduced : {true, false})
      {
        const auto make = [&]() -> std::unique_ptr<TransientIntegrator> {
          if (is_reduced)
            return std::make_unique<ReducedTransient>(
              r.model, dt, falls, force);
          return std::make_unique<ImplicitTransient>(
            full_model(r), dt, falls, force);
        };
        const std::string name  = is_reduced ? "reduced" : "implicit";
        const auto        whole = make(), second = make();
        start(*whole);
        start(*second);
        unsigned int n_stick = 0, n_open = 0;
        const auto   advance = [&](TransientIntegrator &run) {
          for (unsigned int i = 0; i < 400; ++i)
            {
              run.advance();
              for (const auto status : run.status())
                {
                  n_stick += status == ContactStatus::stick;
                  n_open += status == ContactStatus::open;
                }
            }
        };
        advance(*whole);
        second->restore(whole->memory());
        advance(*whole);
        advance(*second);
        check(n_open > 0 && n_stick > 0, name + ": nodes open and stick");
        std::printf(
          "%s: %u sticking, %u open\n", name.c_str(), n_stick, n_open);
        check(same_bits(*whole, *second),
              name + ": the same bits after a restart with a falling law");
      }
  }
} // namespace

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const std::string                        which = argc > 1 ? argv[1] : "";
  if (which == "growth")
    growing_brake();
  else if (which == "bits")
    bits();
  else
    check(false, "an argument: growth or bits");
}
