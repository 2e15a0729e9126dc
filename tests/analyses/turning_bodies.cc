// SPDX-License-Identifier: LGPL-2.1-or-later

// A thin ring that turns faster than its critical speed is computed, with all
// the motions that turning carries into the band; its lost stiffness is no
// motion that nothing holds, and the critical speed is named.

#include "scenes.h"

#include <squeal/base/run_log.h>
#include <squeal/base/timers.h>
#include <squeal/model/cea_solution.h>
#include <squeal/model/turning_modes.h>

#include <deal.II/base/mpi.h>

#include <sstream>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  constexpr double pi = 3.14159265358979323846;

  /** The ring and how it is solved. */
  struct Ring
  {
    Ring(const double speed, const double lowest, const double highest)
      : log(false)
    {
      auto &body                         = parameters.scene.bodies;
      body                               = {make_annulus({{48, 1, 1}}, .006)};
      body[0].inner_radius               = .099;
      body[0].outer_radius               = .101;
      body[0].rotation_speed             = speed;
      parameters.discretization.degree   = 3;
      parameters.eigen.lowest_frequency  = lowest;
      parameters.eigen.highest_frequency = highest;
      model    = std::make_unique<squeal::Model>(parameters, timers);
      solution = solve_modes(*model, log, timers);
    }

    Parameters                     parameters;
    Timers                         timers;
    RunLog                         log;
    std::unique_ptr<squeal::Model> model;
    ModeSolution                   solution;
  };

  /** Frequency at rest with m nodal diameters, rad/s: omega_m^2 = E h^2
   * m^2 (m^2 - 1)^2 / (12 rho R^4 (m^2 + 1)), as the mesh has it. */
  double
  at_rest(const Ring &still, const int m)
  {
    const double thin = std::sqrt(210e9 / 7800. / 12.) * .002 / .01 * m *
                        (m * m - 1.) / std::sqrt(m * m + 1.);
    double best = 0.;
    for (const double square : still.solution.modes.omega_squared)
      if (square > 0. &&
          std::abs(std::sqrt(square) - thin) < std::abs(best - thin))
        best = std::sqrt(square);
    check_close(best, thin, 5e-3, "at rest, m = " + std::to_string(m));
    return best;
  }

  /** In the fixed frame |sqrt(omega_m^2 - (Omega r)^2) +- m Omega r| with
   * r = (m^2 - 1) / (m^2 + 1), inextensional: Bryan's split at any speed. */
  double
  fixed_frame(const double omega, const int m, const double speed, const int to)
  {
    const double r = speed * (m * m - 1.) / (m * m + 1.);
    return std::abs(std::sqrt(omega * omega - r * r) + to * m * r);
  }

  void
  check_motion(const ComplexPairs &pairs,
               const Ring         &still,
               const double        speed,
               const int           m,
               const int           to)
  {
    const double expected     = fixed_frame(at_rest(still, m), m, speed, to);
    std::complex<double> best = 0.;
    for (const auto lambda : pairs.lambda)
      if (std::abs(lambda.imag() - expected) < std::abs(best.imag() - expected))
        best = lambda;
    // (h/R)^2 = 4e-4 of extension and shear, on what turning adds.
    check_close(best.imag(),
                expected,
                2e-3 * m * speed / expected,
                std::to_string(speed) + " rad/s, m = " + std::to_string(m));
    check(std::abs(best.real()) <= 1e-6 * std::abs(best),
          "turning alone does not damp, sigma " + std::to_string(best.real()));
  }

  ComplexPairs
  pairs_of(Ring &ring)
  {
    return solve_cea(*ring.model, ring.solution, ring.log, ring.timers).pairs;
  }

  std::string
  warning(const double speed)
  {
    const Ring ring(speed, 10., 105.);
    return beyond_critical_speed(*ring.model, ring.solution);
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize init(argc, argv, 1);
  const Ring                               still(0., 10., 800.);
  {
    const double speed = 300.;
    Ring         slow(speed, 60., 300.);
    check(free_motions(*slow.model, slow.solution).substr(0, 9) == "6 motions",
          "six motions that nothing holds: " +
            free_motions(*slow.model, slow.solution));
    const ComplexPairs pairs = pairs_of(slow);
    check_motion(pairs, still, speed, 2, -1);
    check_motion(pairs, still, speed, 2, 1);
    check_motion(pairs, still, speed, 3, -1);
  }
  const double speed = 700.;
  {
    Ring fast(speed, 15., 105.);
    check(free_motions(*fast.model, fast.solution).substr(0, 9) == "6 motions",
          "and no more of them beyond the critical speed: " +
            free_motions(*fast.model, fast.solution));
    const ComplexPairs pairs = pairs_of(fast);
    check_motion(pairs, still, speed, 2, -1);
    check_motion(pairs, still, speed, 3, -1);
  }
  {
    Ring               fast(speed, 130., 330.);
    const ComplexPairs pairs = pairs_of(fast);
    check_motion(pairs, still, speed, 2, 1);
    // At rest at 694 Hz.
    check_motion(pairs, still, speed, 4, -1);
  }
  const std::string text = warning(speed), name = "critical speed of ";
  const auto        at = text.find(name);
  check(at != std::string::npos, "the critical speed is named: " + text);
  const double critical = std::stod(text.substr(at + name.size()));
  // sqrt(omega^2 - (Omega r)^2) = m Omega r
  check_close(critical,
              at_rest(still, 2) / .6 / std::sqrt(5.),
              1e-3,
              "that of m = 2 in closed form");
  check(warning(.99 * critical).empty(), "nothing is said below it");
  check(!warning(1.01 * critical).empty(), "nor left unsaid above it");
}
