// SPDX-License-Identifier: LGPL-2.1-or-later

// A thin free ring that turns is computed with all the motions that turning
// carries into the band, and nothing of it grows: the stress of the turning
// keeps its waves from a critical speed. That of a thin disc is named. Growth
// rates that are rounding have no error by the mesh, whatever their sign.

#include "scenes.h"
#include "worst.h"

#include <squeal/base/run_log.h>
#include <squeal/base/timers.h>
#include <squeal/model/cea_solution.h>
#include <squeal/model/growth_errors.h>
#include <squeal/model/second_solutions.h>
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

  /** In the fixed frame sqrt(omega_m^2 + (m Omega r)^2) +- m Omega r with
   * r = (m^2 - 1) / (m^2 + 1): an inextensional ring with the tension
   * rho (Omega R)^2 of its turning, at any speed. */
  double
  fixed_frame(const double omega, const int m, const double speed, const int to)
  {
    const double c = m * speed * (m * m - 1.) / (m * m + 1.);
    return std::sqrt(omega * omega + c * c) + to * c;
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

  CeaSolution
  solve(Ring &ring)
  {
    return solve_cea(*ring.model, ring.solution, ring.log, ring.timers);
  }

  void
  check_nothing_grows(const CeaSolution &solution, const std::string &claim)
  {
    check(solution.growth_below.real() < 1e-2, claim + ", below the band");
    Worst growth;
    for (const auto lambda : solution.pairs.lambda)
      growth.add(lambda.real());
    check_below(growth.largest(), 1e-3, claim);
  }

  /** A thin disc that is clamped at its bore. */
  Parameters
  disc(const double speed)
  {
    Parameters p;
    p.scene.bodies                   = {make_annulus({{24, 2, 1}}, .002)};
    p.scene.bodies[0].inner_radius   = .04;
    p.scene.bodies[0].outer_radius   = .14;
    p.scene.bodies[0].rotation_speed = speed;
    p.scene.supports                 = {make_clamp("disc", "inner")};
    p.discretization.degree          = 2;
    p.eigen.lowest_frequency         = 5.;
    p.eigen.highest_frequency        = 400.;
    return p;
  }

  std::string
  warning(const double speed)
  {
    const Parameters   p = disc(speed);
    Timers             timers;
    RunLog             log(false);
    squeal::Model      model(p, timers);
    const ModeSolution solution = solve_modes(model, log, timers);
    return beyond_critical_speed(model, solution);
  }

  /** What the warning at @p speed names, rad/s. */
  double
  critical_speed(const double speed)
  {
    const std::string text = warning(speed), name = "critical speed of ";
    const auto        at = text.find(name);
    check(at != std::string::npos, "the critical speed is named: " + text);
    return std::stod(text.substr(at + name.size()));
  }

  /** One pair grows, the others have rounding of either sign. */
  void
  check_rounding_has_no_error(Ring &ring, const CeaSolution &solution)
  {
    ComplexPairs pairs = solution.pairs;
    for (unsigned int k = 0; k < pairs.size(); ++k)
      pairs.lambda[k].real((k == 0       ? 1e-3
                            : k % 2 == 0 ? 1e-12
                                         : -1e-12) *
                           std::abs(pairs.lambda[k]));
    SecondSolutions        second;
    const Eigen::VectorXcd errors =
      growth_errors_by_lower_degree(*ring.model,
                                    pairs,
                                    PairErrors::unknown(pairs.size()),
                                    second,
                                    ring.timers);
    check(pairs.size() > 2 && std::isfinite(errors[0].real()),
          "what grows has an error by the mesh");
    for (unsigned int k = 1; k < pairs.size(); ++k)
      check(std::isnan(errors[k].real()),
            "a growth rate that is rounding has none");
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
    const CeaSolution solution = solve(slow);
    check_nothing_grows(solution, "a free ring that turns does not grow");
    check_rounding_has_no_error(slow, solution);
    check_motion(solution.pairs, still, speed, 2, -1);
    check_motion(solution.pairs, still, speed, 2, 1);
    check_motion(solution.pairs, still, speed, 3, -1);
  }
  const double speed = 700.;
  {
    Ring              fast(speed, 10., 420.);
    const CeaSolution solution = solve(fast);
    check_nothing_grows(solution, "nor where it turns fast");
    check(free_motions(*fast.model, fast.solution).substr(0, 9) == "6 motions",
          "six motions of a fast ring: " +
            free_motions(*fast.model, fast.solution));
    check_motion(solution.pairs, still, speed, 2, -1);
    check_motion(solution.pairs, still, speed, 3, -1);
    // At rest at 694 Hz.
    check_motion(solution.pairs, still, speed, 4, -1);
  }
  const double critical = critical_speed(1200.);
  check(critical < 1200. && warning(300.).empty(),
        "the critical speed is below the speed, and nothing is said below it");
}
