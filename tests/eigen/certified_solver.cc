// SPDX-License-Identifier: LGPL-2.1-or-later

// The certified reduced solution of a coarse brake: damping and symmetry in
// closed form, agreement with the direct solver, honest error estimates.

#include "scenes.h"
#include "worst.h"

#include <squeal/eigen/direct_solver.h>

#include <deal.II/base/mpi.h>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  using Complex = std::complex<double>;

  constexpr double top = 8000.;

  void
  test_no_friction()
  {
    const SceneParameters scene = coarse_brake(0.);
    Model                 model(scene, 2, top);
    const UndampedModes   modes = undamped_modes(model.pencil, model.inverse);
    CertifiedSolver       solver(model.pencil, model.inverse, modes);
    const ComplexPairs    pairs = solver.solve(band(100., top));
    check(pairs.size() > 8, "pairs: " + std::to_string(pairs.size()));
    const double alpha = scene.damping.mass_damping,
                 beta  = scene.damping.stiffness_damping;
    for (unsigned int i = 0; i < pairs.size(); ++i)
      {
        const Complex l  = pairs.lambda[i];
        const double  w2 = std::norm(l);
        check_below(std::abs(l.real() + .5 * (alpha + beta * w2)),
                    1e-8 * std::abs(l),
                    "mu = 0: sigma = -(alpha + beta omega^2) / 2 at " +
                      number(pairs.frequency(i)) + " Hz");
        check_below((modes.omega_squared.array() / w2 - 1.)
                      .abs()
                      .minCoeff<Eigen::PropagateNaN>(),
                    1e-8,
                    "mu = 0: |lambda| is an undamped frequency");
      }
  }

  void
  test_mirror()
  {
    Model      a(coarse_brake(.4), 2, top), b(coarse_brake(-.4), 2, top);
    const auto x = a.solve(band(500., top)), y = b.solve(band(500., top));
    check(x.size() == y.size() && x.size() > 8, "as many pairs mirrored");
    for (unsigned int i = 0; i < x.size(); ++i)
      check_below(distance(y.lambda, x.lambda[i]),
                  1e-9,
                  "turning backwards mirrors the scene, " +
                    number(x.frequency(i)) + " Hz");
  }

  void
  check_against_direct(const SceneParameters &scene, const std::string &name)
  {
    Model              model(scene, 2, top);
    const ComplexPairs certified = model.solve(band(500., top));
    check(certified.size() > 8, name + ": pairs in the band");
    const DirectSolver direct(model.pencil, Complex(100., M_PI * top));
    ComplexPairs       exact = direct.solve(certified.size() + 12);
    direct.find_conditions(exact);
    Worst worst, of_conditions;
    for (unsigned int i = 0; i < certified.size(); ++i)
      {
        worst.add(distance(exact.lambda, certified.lambda[i]));
        Eigen::Index same = 0;
        (exact.lambda.array() - certified.lambda[i]).abs().minCoeff(&same);
        of_conditions.add(
          std::abs(exact.condition[same] / certified.condition[i] - 1.));
      }
    check_below(worst.largest(), 1e-8, name + ": certified against direct");
    check_below(
      of_conditions.largest(), 1e-4, name + ": the conditions of both agree");
    unsigned int n = 0;
    for (unsigned int i = 0; i < exact.size(); ++i)
      if (exact.frequency(i) > 500. && exact.frequency(i) < top &&
          std::abs(exact.lambda[i]) < 4. * M_PI * top)
        ++n;
    check(n == certified.size(),
          name + ": the direct solver finds as many: " + std::to_string(n));
    check_below(certified.residual.maxCoeff<Eigen::PropagateNaN>(),
                1e-8,
                name + ": residuals");
    // Left vectors: dlambda by the Rayleigh quotient is stationary.
    const auto products = model.pencil.apply(certified.right);
    for (unsigned int i = 0; i < certified.size(); ++i)
      {
        const Complex l = certified.lambda[i];
        const Complex d =
          certified.left.col(i).transpose() *
          (2. * l * products.mass.col(i) + products.damping.col(i));
        const Complex r =
          certified.left.col(i).transpose() *
          (l * l * products.mass.col(i) + l * products.damping.col(i) +
           products.stiffness.col(i));
        if (!model.pencil.has_structural_damping())
          check_below(std::abs(r / d) / std::abs(l),
                      1e-10,
                      name + ": two-sided Rayleigh quotient");
      }
  }

  void
  test_direct()
  {
    check_against_direct(coarse_brake(.5), "Rayleigh damping");
    SceneParameters scene                  = coarse_brake(.5);
    scene.damping.model                    = DampingParameters::Model::per_part;
    scene.bodies[1].stiffness_damping      = 1e-6;
    scene.bodies[2].mass_damping           = 20.;
    scene.contacts[0].transverse_slip_term = true;
    check_against_direct(scene, "damping by parts");
    scene.bodies[1].structural_damping = .02;
    check_against_direct(scene, "structural damping");
  }

  /** Estimates of a basis that is left coarse on purpose, by loose tolerances
   * and without the supplement of the Lanczos iteration. */
  void
  test_estimate()
  {
    Model      model(coarse_brake(.5), 2, top);
    const auto modes = undamped_modes(model.pencil, model.inverse);
    // The tightest basis is the reference, since the direct solver is only good
    // to some 1e-9 (which it confirms).
    CertifiedOptions tight   = band(500., top);
    tight.residual_tolerance = 1e-11;
    const Eigen::VectorXcd exact =
      CertifiedSolver(model.pencil, model.inverse, modes).solve(tight).lambda;
    const DirectSolver     direct(model.pencil, Complex(100., M_PI * top));
    const Eigen::VectorXcd other = direct.solve(40).lambda;
    for (const Complex lambda : exact)
      check_below(distance(other, lambda), 1e-8, "the direct solver agrees");
    unsigned int n_compared = 0, n_dishonest = 0;
    for (const bool supplement : {false, true})
      for (const double tolerance : {1e-2, 1e-3, 1e-4, 1e-6})
        {
          UndampedModes start = modes;
          if (!supplement)
            start.supplement.resize(start.shapes.rows(), 0);
          CertifiedOptions options   = band(500., top);
          options.residual_tolerance = tolerance;
          options.error_tolerance    = tolerance;
          CertifiedSolver    solver(model.pencil, model.inverse, start);
          const ComplexPairs pairs = solver.solve(options);
          check(pairs.error_estimate.maxCoeff<Eigen::PropagateNaN>() > 0.,
                "the estimate does not vanish identically, tolerance " +
                  number(tolerance));
          for (unsigned int i = 0; i < pairs.size(); ++i)
            {
              const double error = distance(exact, pairs.lambda[i]);
              if (error < 1e-10)
                continue;
              ++n_compared;
              const double ratio = pairs.error_estimate[i] / error;
              if (ratio > 1. / 3. && ratio < 3.)
                continue;
              ++n_dishonest;
              std::cout << "tolerance " << number(tolerance) << ", "
                        << number(pairs.frequency(i)) << " Hz: estimate "
                        << number(pairs.error_estimate[i]) << ", error "
                        << number(error) << "\n";
            }
        }
    check(n_compared > 4,
          "errors large enough to be compared: " + std::to_string(n_compared));
    check(n_dishonest == 0,
          "estimates within a factor 3 of the true errors: all but " +
            std::to_string(n_dishonest));
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize init(argc, argv, 1);
  const std::string                        what = argc > 1 ? argv[1] : "";
  if (what == "closed_forms")
    {
      test_no_friction();
      test_mirror();
    }
  else if (what == "direct")
    test_direct();
  else if (what == "estimate")
    test_estimate();
  else
    check(false, "one argument: closed_forms, direct or estimate");
  return 0;
}
