// SPDX-License-Identifier: LGPL-2.1-or-later

// Half the time step and half the disturbance change the growth rate by less
// than its confidence interval; with friction that follows the slip rate of the
// step before the schemes do what is stated.

#include "transient/pressed_brake.h"

#include <squeal/transient/growth.h>
#include <squeal/transient/reduced_transient.h>
#include <squeal/transient/time_step_error.h>

#include <deal.II/base/mpi.h>

#include <cmath>
#include <cstdio>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  constexpr double mu         = .5;
  constexpr double e_foldings = 12.;

  /** A fit, and the same with what the time step adds in its intervals. */
  struct Growth
  {
    GrowthFit fitted, whole;
  };

  /** Growth from a disturbance of @p energy, J, in steps of @p dt, s. */
  Growth
  growth(const Reduced          &r,
         const SteadySliding    &s,
         const LinearizedMotion &linear,
         const double            dt,
         const double            energy)
  {
    Eigen::Index         worst;
    const double         rate = linear.lambda.real().maxCoeff(&worst);
    const TransientDrive drive{[](double) { return mu; },
                               [](double) { return speed; },
                               [](double) { return 1.; },
                               {},
                               {}};
    ReducedTransient run(r.model, dt, drive, load / r.model.n_nodes(), 1e-10);
    Eigen::VectorXd  v =
      r.model.participation.transpose() *
      Eigen::VectorXd::LinSpaced(3 * r.model.n_nodes(), 1., 2.);
    v *= std::sqrt(2. * energy) / v.norm();
    run.start(s.coordinates, v, s.forces);
    std::vector<double>               times;
    std::vector<std::complex<double>> amplitudes;
    while (run.time() < e_foldings / rate)
      {
        run.advance();
        if (run.time() >= 2e-5 * (times.size() + 1) - 1e-12)
          {
            times.push_back(run.time());
            amplitudes.push_back(linear.amplitudes(
              s, run.coordinates(), run.velocities(), run.forces())[worst]);
          }
      }
    check(run.status() == s.status, "the contact state stays");
    const auto window = fit_window(amplitudes, 0, amplitudes.size(), false);
    const GrowthFit fitted =
      fit_growth(times, amplitudes, window.first, window.second);
    GrowthFit                  fit = fitted;
    const std::complex<double> error =
      reduced_step_error(r.model, linear, dt)[worst];
    check_below(
      std::abs(std::complex<double>(fit.rate, 2. * M_PI * fit.frequency) -
               linear.lambda[worst] - error),
      .02 * std::abs(error),
      "what the time step adds is known");
    fit.include(error);
    std::printf("dt %.1e s, %.1e J: %.5f +- %.5f 1/s, %.5f +- %.5f Hz (%.5f, "
                "%.5f), of the fit %.1e, %.1e\n",
                dt,
                energy,
                fit.rate,
                fit.rate_ci,
                fit.frequency,
                fit.frequency_ci,
                rate,
                linear.lambda[worst].imag() / (2 * M_PI),
                fitted.rate_ci,
                fitted.frequency_ci);
    check(fit.is_valid && fit.e_foldings() >= 3., "three e-foldings and more");
    return {fitted, fit};
  }

  /** What the schemes make of e^(lambda t), from their amplification: the rule
   * misses terms of the next order only. */
  void
  schemes()
  {
    using Complex        = std::complex<double>;
    const Complex lambda = {300., 2. * M_PI * 5e3};
    // Smallest orders of what is left: lambda (lambda dt)^4 and, with loss,
    // lambda (lambda dt)^2.
    for (const auto &[beta_2, order] : {std::make_pair(0., 4.),
                                        std::make_pair(.5, 4.),
                                        std::make_pair(.7, 2.)})
      {
        double before = 0.;
        for (const double dt : {4e-6, 2e-6, 1e-6})
          {
            const Complex z = lambda * dt;
            Complex       factor, error;
            if (beta_2 == 0.)
              {
                factor = (1. + z / 2.) / (1. - z / 2.);
                error  = implicit_step_error(lambda, dt);
              }
            else
              {
                const Complex b = 1. + .5 * z * z * (beta_2 + .5);
                const Complex root =
                  std::sqrt(b * b - 1. + z * z * (.5 - beta_2));
                factor = std::abs(b + root - std::exp(z)) <
                             std::abs(b - root - std::exp(z))
                           ? b + root
                           : b - root;
                error  = explicit_step_error(lambda, dt, beta_2);
              }
            const double rest =
              std::abs(std::log(factor) / dt - lambda - error);
            if (before > 0.)
              check(std::abs(std::log2(before / rest) - order) < .1,
                    (beta_2 == 0. ? std::string("implicit")
                                  : "explicit, beta_2 = " + number(beta_2)) +
                      ": what is left of the time step's part falls by order " +
                      number(order));
            before = rest;
          }
      }
  }

  /** Oscillators q'' + w^2 q = s q' of 5 kHz whose q' on the right is that of
   * the step before where it drives, of the step itself where it damps, from
   * the equation of each scheme in e^(lambda dt). */
  void
  lagged_schemes()
  {
    using Complex  = std::complex<double>;
    const double w = 2. * M_PI * 5e3;
    for (const bool is_implicit : {true, false})
      for (const double s : {1e3, -1e3})
        for (const double dt : {2e-6, 1e-6, 5e-7})
          {
            const Complex lambda(s / 2., std::sqrt(w * w - s * s / 4.)),
              by_slip           = s * lambda / (2. * lambda - s);
            const auto equation = [&](const Complex l) {
              const Complex Z = std::exp(l * dt), lag = s > 0. ? 1. / Z : 1.;
              if (!is_implicit)
                return (Z - 2. + 1. / Z) / (dt * dt) + w * w -
                       s * lag * (Z - 1.) / dt;
              const Complex rate = 2. / dt * (Z - 1.) / (Z + 1.);
              return rate * rate + w * w - s * rate * lag;
            };
            // Newton's method with a derivative by a difference.
            Complex l = lambda;
            for (unsigned int i = 0; i < 20; ++i)
              l -= 2. * equation(l) / (equation(l + 1.) - equation(l - 1.));
            const Complex stated =
              is_implicit
                ? implicit_step_error(lambda, dt, s > 0. ? by_slip : 0.)
                : explicit_step_error(lambda,
                                      dt,
                                      .5,
                                      s > 0. ? by_slip : 0.,
                                      s > 0. ? 0. : by_slip);
            const std::string name =
              std::string(is_implicit ? "implicit" : "explicit") +
              (s > 0. ? ", lagged friction" : ", rising friction");
            std::printf("%s, dt %.1e s: adds %.4f 1/s, stated "
                        "%.4f 1/s\n",
                        name.c_str(),
                        dt,
                        l.real() - lambda.real(),
                        stated.real());
            check_close(
              stated.real(), l.real() - lambda.real(), .02, name + ": growth");
            check_below(std::abs(stated - l + lambda),
                        .01 * std::abs(stated),
                        name + ": pair");
          }
  }
} // namespace

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  schemes();
  lagged_schemes();
  SceneParameters scene         = pressed_brake(mu);
  scene.bodies[1].young_modulus = 1.6e10;
  const Reduced          r(scene, 24e3);
  const SteadySliding    s      = steady_sliding(r.model, mu);
  const LinearizedMotion linear = linearize(r.model, s, mu, speed);
  const Growth           a      = growth(r, s, linear, 2e-6, 1e-18);
  const auto             compare =
    [&](const std::string &name, const GrowthFit &one, const GrowthFit &other) {
      check_below(
        std::abs(other.rate - one.rate), one.rate_ci, name + ": growth rate");
      check_below(std::abs(other.frequency - one.frequency),
                  one.frequency_ci,
                  name + ": frequency");
    };
  compare(
    "half the time step", a.whole, growth(r, s, linear, 1e-6, 1e-18).whole);
  // The time step adds the same to both.
  compare(
    "half the disturbance", a.fitted, growth(r, s, linear, 2e-6, 5e-19).fitted);
  // Wide intervals would hold any rate.
  check_below(a.whole.rate_ci / a.whole.rate, .0025, "interval of the rate");
  check_below(a.whole.frequency_ci / a.whole.frequency,
              3e-5,
              "interval of the frequency");
}
