// SPDX-License-Identifier: LGPL-2.1-or-later

// Half the time step and half the disturbance change the growth rate by less
// than its confidence interval.

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

  /** Growth from a disturbance of @p energy, J, in steps of @p dt, s. */
  GrowthFit
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
    GrowthFit  fit = fit_growth(times, amplitudes, window.first, window.second);
    const std::complex<double> error =
      reduced_step_error(r.model, linear, dt)[worst];
    check_below(
      std::abs(std::complex<double>(fit.rate, 2. * M_PI * fit.frequency) -
               linear.lambda[worst] - error),
      .02 * std::abs(error),
      "what the time step adds is known");
    fit.include(error);
    std::printf("dt %.1e s, %.1e J: %.5f +- %.5f 1/s, %.5f +- %.5f Hz (%.5f, "
                "%.5f)\n",
                dt,
                energy,
                fit.rate,
                fit.rate_ci,
                fit.frequency,
                fit.frequency_ci,
                rate,
                linear.lambda[worst].imag() / (2 * M_PI));
    check(fit.is_valid && fit.e_foldings() >= 3., "three e-foldings and more");
    return fit;
  }
} // namespace

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  SceneParameters                          scene = pressed_brake(mu);
  scene.bodies[1].young_modulus                  = 1.6e10;
  const Reduced          r(scene, 24e3);
  const SteadySliding    s           = steady_sliding(r.model, mu);
  const LinearizedMotion linear      = linearize(r.model, s, mu, speed);
  const GrowthFit        whole       = growth(r, s, linear, 2e-6, 1e-18);
  const GrowthFit        half_step   = growth(r, s, linear, 1e-6, 1e-18);
  const GrowthFit        half_energy = growth(r, s, linear, 2e-6, 5e-19);
  for (const auto &[name, other] :
       {std::make_pair("half the time step", half_step),
        std::make_pair("half the disturbance", half_energy)})
    {
      check_below(std::abs(other.rate - whole.rate),
                  whole.rate_ci,
                  std::string(name) + ": growth rate");
      check_below(std::abs(other.frequency - whole.frequency),
                  whole.frequency_ci,
                  std::string(name) + ": frequency");
    }
}
