// SPDX-License-Identifier: LGPL-2.1-or-later

// The coarse brake in all its unknowns: growth in time by the implicit and the
// explicit integrator beside the eigenvalues of the same matrices, energies,
// and the largest stable step.

#include "transient/hand_made.h"
#include "transient/pressed_brake.h"
#include "worst.h"

#include <squeal/base/exceptions.h>
#include <squeal/transient/explicit_transient.h>
#include <squeal/transient/growth.h>
#include <squeal/transient/implicit_transient.h>
#include <squeal/transient/modal_step.h>
#include <squeal/transient/reduced_transient.h>

#include <deal.II/base/mpi.h>

#include <chrono>
#include <cmath>
#include <cstdio>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  using Complex = std::complex<double>;

  constexpr double mu = .5;

  SceneParameters
  squealing_brake()
  {
    SceneParameters scene         = pressed_brake(mu);
    scene.bodies[1].young_modulus = 1.6e10;
    // Its face matches that of the pad, as the explicit scheme needs it.
    scene.bodies[2].cells = {{2, 2, 3}};
    return scene;
  }

  TransientDrive
  drive()
  {
    TransientDrive d;
    d.friction = [](double) { return mu; };
    d.speed    = [](double) { return speed; };
    d.load     = [](double) { return 1.; };
    return d;
  }

  /** Grows by some e-foldings and compares with the eigenvalues of the @p whole
   * model about the same state. */
  void
  compare(const std::string      &name,
          const Reduced          &r,
          const SteadySliding    &s,
          const Eigen::VectorXcd &whole,
          TransientIntegrator    &run,
          const double            e_foldings,
          const double            share = .02)
  {
    const LinearizedMotion linear = linearize(r.model, s, mu, speed);
    Eigen::Index           worst;
    linear.lambda.real().maxCoeff(&worst);
    Complex exact = whole[0];
    for (const Complex &l : whole)
      if (std::abs(l - linear.lambda[worst]) <
          std::abs(exact - linear.lambda[worst]))
        exact = l;
    run.start(s.coordinates,
              Eigen::VectorXd::Constant(r.model.n_modes(), 1e-9),
              s.forces);
    std::vector<double>  times;
    std::vector<Complex> amplitudes;
    unsigned int         n = 0, iterations = 0;
    bool                 same_status = true;
    const auto           begin       = std::chrono::steady_clock::now();
    while (run.time() < e_foldings / exact.real())
      {
        iterations += run.advance().iterations;
        ++n;
        same_status = same_status && run.status() == s.status;
        if (run.time() >= times.size() * 2e-5)
          {
            times.push_back(run.time());
            amplitudes.push_back(linear.amplitudes(
              s, run.coordinates(), run.velocities(), run.forces())[worst]);
          }
      }
    const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin)
        .count();
    const auto window = fit_window(amplitudes, 0, amplitudes.size(), false);
    const GrowthFit fit =
      fit_growth(times, amplitudes, window.first, window.second);
    const double f = exact.imag() / (2 * M_PI);
    std::printf("%s: rate %.4f +- %.4f (%.4f, reduced %.4f), f %.4f (%.4f), "
                "imbalance %.2e, numerical %.2e of %.2e J, %.2f iterations a "
                "step, %.0f steps/s\n",
                name.c_str(),
                fit.rate,
                fit.rate_ci,
                exact.real(),
                linear.lambda[worst].real(),
                fit.frequency,
                f,
                run.ledger().imbalance(),
                run.ledger().numerical,
                run.ledger().driving,
                double(iterations) / n,
                n / seconds);
    check(same_status, name + ": the contact state stays");
    check_below(std::abs(fit.rate - exact.real()),
                std::max(share * exact.real(), 3.),
                name + ": growth rate");
    check_below(std::abs(fit.frequency / f - 1.), 2e-3, name + ": frequency");
    // An identity of the scheme, to rounding in forces that add up for long.
    check_below(run.ledger().imbalance(), 1e-7, name + ": the ledger closes");
  }

  void
  implicit()
  {
    const Reduced       r(squealing_brake(), 24e3);
    const SteadySliding s = steady_sliding(r.model, mu);
    ImplicitTransient   run(
      full_model(r), 2e-6, drive(), load / r.model.n_nodes());
    compare("implicit", r, s, whole_model(r, s), run, 4.);
  }

  /** What the model says that the motions above its cut-off add to the growing
   * pair is what they add. */
  void
  reduction_is_stated(const Reduced          &r,
                      const SteadySliding    &s,
                      const Eigen::VectorXcd &whole)
  {
    const NodalFriction uniform = NodalFriction::uniform(mu, r.model.n_nodes());
    const LinearizedMotion linear = linearize(r.model, s, uniform, speed);
    const Eigen::VectorXcd stated =
      reduction_error(r.model, s, uniform, speed, linear);
    Eigen::Index k, i;
    linear.lambda.real().maxCoeff(&k);
    (whole.array() - linear.lambda[k]).abs().minCoeff(&i);
    const Complex found = whole[i] - linear.lambda[k];
    std::printf("motions above the cut-off: stated %+.2f 1/s, %+.3f Hz; found "
                "%+.2f 1/s, %+.3f Hz\n",
                stated[k].real(),
                stated[k].imag() / (2. * M_PI),
                found.real(),
                found.imag() / (2. * M_PI));
    check_close(stated[k].real(),
                found.real(),
                .2,
                "what the cut-off does to the growth rate");
    check_close(stated[k].imag(),
                found.imag(),
                .2,
                "what the cut-off does to the frequency");
  }

  /** Each body with a damping of its own, which couples the modes, in all three
   * integrators. */
  void
  damping_of_parts()
  {
    SceneParameters scene             = squealing_brake();
    scene.damping                     = {};
    scene.damping.model               = DampingParameters::Model::per_part;
    scene.bodies[0].stiffness_damping = 2e-8;
    scene.bodies[1].stiffness_damping = 1e-6;
    scene.bodies[2].mass_damping      = 40.;
    const Reduced r(scene, 24e3, 0., true);
    check(r.model.has_coupled_damping(), "bodies of their own couple modes");
    const SteadySliding s = steady_sliding(r.model, mu);

    const Reduced          undamped(squealing_brake(), 24e3, 0., true);
    const SteadySliding    other = steady_sliding(undamped.model, mu);
    const Eigen::VectorXcd whole = whole_model(r, s);
    const double           with  = largest(whole.real()),
                 without         = largest(whole_model(undamped, other).real());
    std::printf(
      "damping of parts takes %.2f of %.2f 1/s\n", without - with, without);
    check(without - with > 30., "the damping of the parts counts");

    const double nodal = load / r.model.n_nodes();
    reduction_is_stated(r, s, whole);
    ReducedTransient reduced(r.model, 1.5e-6, drive(), nodal);
    // The pad is soft: much of its damping is in motions above the cut-off.
    compare("parts, reduced", r, s, whole, reduced, 7., .2);
    ImplicitTransient implicit_run(full_model(r), 2e-6, drive(), nodal);
    compare("parts, implicit", r, s, whole, implicit_run, 2.);
    const double largest_step =
      ExplicitTransient(full_model(r), 1e-8, drive(), nodal).largest_step();
    std::printf("largest step of the explicit scheme: %.2e s\n", largest_step);
    ExplicitTransient explicit_run(
      full_model(r), .95 * largest_step, drive(), nodal);
    compare("parts, explicit", r, s, whole, explicit_run, 2.);
    check_close(explicit_run.largest_step(),
                largest_step,
                1e-6,
                "the largest step is stated");
  }

  /** Modes of one frequency, damped along other directions than their own: the
   * step turned into those directions is that of each by itself. */
  void
  coupled_step()
  {
    constexpr double dt = 3e-6;
    for (const double c : {10., 1e3, 1e6})
      {
        ReducedContactModel own = empty_model(1, 3), turned = own;
        own.omega_squared << 4e10, 4e10, 1e11;
        own.damping << c, .1 * c, .3 * c;
        Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
        R.topLeftCorner<2, 2>() << .6, -.8, .8, .6;
        turned.omega_squared    = own.omega_squared;
        const Eigen::Matrix3d D = R * own.damping.asDiagonal() * R.transpose();
        turned.damping          = D.diagonal();
        turned.damping_coupling = D;
        turned.damping_coupling.diagonal().setZero();
        const ModalStep       a(own, dt), b(turned, dt);
        const Eigen::MatrixXd I    = Eigen::Matrix3d::Identity();
        const auto            same = [&](const char          *name,
                              const ModalOperator &x,
                              const ModalOperator &y) {
          const Eigen::MatrixXd expected = R * (x * I) * R.transpose();
          check_below((y * I - expected).norm() / expected.norm(),
                      1e-13,
                      "damping of " + number(c) + " 1/s: " + name);
        };
        same("q by q", a.q_q, b.q_q);
        same("q by v", a.q_v, b.q_v);
        same("q by the force at the start", a.q_f0, b.q_f0);
        same("q by the force at the end", a.q_f1, b.q_f1);
        same("v by q", a.v_q, b.v_q);
        same("v by v", a.v_v, b.v_v);
        same("v by the force at the start", a.v_f0, b.v_f0);
        same("v by the force at the end", a.v_f1, b.v_f1);
      }
  }

  void
  explicit_scheme()
  {
    const Reduced       r(squealing_brake(), 24e3, 0., true);
    const SteadySliding s    = steady_sliding(r.model, mu);
    double              step = 0.;
    try
      {
        ExplicitTransient(
          full_model(r), 1e-5, drive(), load / r.model.n_nodes());
        check(false, "a step above the critical one is refused");
      }
    catch (const InputError &e)
      {
        const std::string text = e.what();
        std::printf("%s\n", text.c_str());
        step = std::stod(text.substr(text.rfind("integrator, ") + 12));
      }
    ExplicitTransient run(
      full_model(r), .95 * step, drive(), load / r.model.n_nodes());
    compare("explicit", r, s, whole_model(r, s), run, 4.5);
  }

  /** The bodies thrown apart: no contact, energy and damping alone. */
  void
  flight()
  {
    const Reduced    r(squealing_brake(), 24e3, 0., true);
    FullContactModel full = full_model(r);
    full.initial_gap.setConstant(1.);
    full.load.setZero();
    const Eigen::VectorXd none = Eigen::VectorXd::Zero(3 * r.model.n_nodes());
    const Eigen::VectorXd q    = Eigen::VectorXd::Zero(r.model.n_modes()),
                          v = Eigen::VectorXd::Constant(r.model.n_modes(), .1);
    ImplicitTransient implicit_run(
      full, 2e-6, drive(), load / r.model.n_nodes());
    implicit_run.start(q, v, none);
    ExplicitTransient explicit_run(full,
                                   5e-8,
                                   drive(),
                                   load / r.model.n_nodes(),
                                   1e-8,
                                   ContactSolver::Method::newton,
                                   .6);
    explicit_run.start(q, v, none);
    while (implicit_run.time() < 2e-4)
      implicit_run.advance();
    while (explicit_run.time() < 2e-4)
      explicit_run.advance();
    std::printf("implicit: %.2e, explicit: %.2e, numerical %.2e of %.2e J\n",
                implicit_run.ledger().imbalance(),
                explicit_run.ledger().imbalance(),
                explicit_run.ledger().numerical,
                explicit_run.ledger().start);
    check_below(implicit_run.ledger().imbalance(),
                1e-6,
                "implicit without contact: the ledger closes");
    check_below(explicit_run.ledger().imbalance(),
                1e-6,
                "explicit without contact, beta_2 = 0.6: the ledger closes");
    check(explicit_run.ledger().numerical > 0.,
          "beta_2 above one half takes energy");
  }

  /** The stability limit of one oscillator, on both sides. */
  void
  stability_limit()
  {
    for (const double beta_2 : {.5, .7})
      for (const double damping : {0., 3e-1, 2.})
        {
          // omega = 1, c = damping.
          const double limit = critical_step(1., damping, 0., beta_2);
          for (const double factor : {.999, 1.001})
            {
              const double h = factor * limit;
              Worst        largest;
              double       u = 1., w = 0.;
              for (unsigned int n = 0; n < 20000; ++n)
                {
                  const double a = -damping * w - u;
                  u += h * w + (beta_2 + .5) * h * h * a;
                  w += h * a;
                  largest.add(std::abs(u));
                }
              check((largest.largest() < 1e3) == (factor < 1.),
                    "beta_2 " + number(beta_2) + ", damping " +
                      number(damping) + ", " + number(factor) +
                      " of the critical step");
            }
        }
  }
} // namespace

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const std::string                        which = argc > 1 ? argv[1] : "";
  if (which == "implicit")
    implicit();
  else if (which == "explicit")
    explicit_scheme();
  else if (which == "damping_of_parts")
    {
      coupled_step();
      damping_of_parts();
    }
  else if (which == "energies")
    {
      stability_limit();
      flight();
    }
  else
    check(false,
          "an argument: implicit, explicit, energies or damping_of_parts");
}
