// SPDX-License-Identifier: LGPL-2.1-or-later

// The error estimate of the certified basis at thirty values of the pad's
// stiffness, ten of them within 1e-4 decades of a lock-in, where single
// eigenvalues are only good to the square root of a perturbation and the
// invariant pair is judged instead.

#include "scenes.h"
#include "worst.h"

#include <squeal/eigen/direct_solver.h>

#include <deal.II/base/mpi.h>

#include <algorithm>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  using Complex = std::complex<double>;

  constexpr double top = 6000.;

  /** Everything at one stiffness 10^x of the pad. */
  struct Point
  {
    explicit Point(const double x)
      : model(scene(x), 2, top)
      , modes(undamped_modes(model.pencil, model.inverse))
    {
    }

    static SceneParameters
    scene(const double x)
    {
      SceneParameters s         = coarse_brake(.5);
      s.bodies[1].cells         = {{1, 1, 1}};
      s.bodies[2].cells         = {{1, 1, 6}};
      s.bodies[1].young_modulus = std::pow(10., x);
      return s;
    }

    ComplexPairs
    solve(const double tolerance) const
    {
      CertifiedOptions options   = band(500., top);
      options.residual_tolerance = tolerance;
      options.error_tolerance    = std::min(1., 10. * tolerance);
      return CertifiedSolver(model.pencil, model.inverse, modes).solve(options);
    }

    Model         model;
    UndampedModes modes;
  };

  /** Squared half-difference of the two eigenvalues nearest to @p wanted, real
   * part: negative while two frequencies differ, positive once they are one. */
  double
  discriminant(const double x, const Complex wanted)
  {
    const Eigen::VectorXcd lambda    = Point(x).solve(1e-8).lambda;
    Eigen::VectorXd        distances = (lambda.array() - wanted).abs();
    Eigen::Index           a, b;
    distances.minCoeff(&a);
    distances[a] = 1e300;
    distances.minCoeff(&b);
    return std::real(.25 * (lambda[a] - lambda[b]) * (lambda[a] - lambda[b]));
  }

  /** Where the pair that is @p unstable at @p inside locks in, to 1e-7 decades.
   * The discriminant is smooth where the eigenvalues have a root of it: regula
   * falsi, with half the value of an end that stays. */
  double
  lock_in(double outside, double inside, const Complex unstable)
  {
    double before = discriminant(outside, unstable),
           after  = discriminant(inside, unstable);
    check(before < 0. && after > 0., "a lock-in lies between");
    double last = outside;
    int    side = 0;
    for (unsigned int i = 0; i < 24; ++i)
      {
        const double x = (outside * after - inside * before) / (after - before),
                     value = discriminant(x, unstable);
        std::cout << "10^" << x << ": " << value << std::endl;
        if (std::abs(x - last) < 1e-7)
          return x;
        last = x;
        if (value > 0.)
          {
            inside = x;
            after  = value;
            before *= side > 0 ? .5 : 1.;
          }
        else
          {
            outside = x;
            before  = value;
            after *= side < 0 ? .5 : 1.;
          }
        side = value > 0. ? 1 : -1;
      }
    check(false, "the lock-in is found");
    return 0.;
  }

  struct Tally
  {
    unsigned int n_compared = 0, n_outside = 0, n_pairs = 0;
    Worst        ratio;
    double       worst_reduced = 0.;
  };

  /** Mean and squared half-difference of pair @p i with its neighbour, as one
   * relative error against @p exact. */
  double
  pair_error(const Eigen::VectorXcd &lambda,
             const unsigned int      i,
             const int               j,
             const Eigen::VectorXcd &exact)
  {
    ComplexPairs two;
    two.lambda.resize(2);
    two.lambda << lambda[i], lambda[j];
    two.condition = Eigen::VectorXd::Constant(2, 1e300);
    estimate_errors(two, exact);
    return two.error_estimate[0];
  }

  /** Returns the pairs of the tightest tolerance. */
  ComplexPairs
  compare(const Point &point, const double x, Tally &tally)
  {
    const ComplexPairs exact = point.solve(1e-11);
    for (const double tolerance : {1e-3, 1e-5})
      {
        const ComplexPairs pairs = point.solve(tolerance);
        check(pairs.size() == exact.size(), "as many pairs at 10^" + number(x));
        for (unsigned int i = 0; i < pairs.size(); ++i)
          {
            const int    j = pairs.pair_partner[i];
            const double error =
              j < 0 ? (exact.lambda.array() - pairs.lambda[i])
                          .abs()
                          .minCoeff<Eigen::PropagateNaN>() /
                        std::abs(pairs.lambda[i])
                    : pair_error(pairs.lambda, i, j, exact.lambda);
            ++tally.n_pairs;
            if (error < 1e-10)
              continue;
            ++tally.n_compared;
            const double ratio = pairs.error_estimate[i] / error;
            tally.ratio.add(ratio);
            if (ratio > 1. / 3. && ratio < 3.)
              continue;
            ++tally.n_outside;
            std::cout << "10^" << x << ", " << pairs.frequency(i)
                      << " Hz, condition " << pairs.condition[i]
                      << (j < 0 ? "" : ", pair") << ": estimate "
                      << pairs.error_estimate[i] << ", error " << error << "\n";
          }
      }
    return exact;
  }

  /** The reference of compare() beside the direct solver. */
  void
  check_reference(const Point &point, const ComplexPairs &exact, const double x)
  {
    const DirectSolver direct(point.model.pencil, Complex(100., M_PI * top));
    const Eigen::VectorXcd other = direct.solve(exact.size() + 12).lambda;
    for (unsigned int i = 0; i < exact.size(); ++i)
      check_below((other.array() - exact.lambda[i])
                      .abs()
                      .minCoeff<Eigen::PropagateNaN>() /
                    std::abs(exact.lambda[i]),
                  1e-7 * std::max(1., exact.condition[i]),
                  "reduced against direct at 10^" + number(x));
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize init(argc, argv, 1);
  Tally                                    tally;
  double  stable = 0., unstable = 0., last_rate = -1.;
  Complex growing;
  for (unsigned int k = 0; k < 20; ++k)
    {
      const double       x = 9. + .1 * k;
      const Point        point(x);
      const ComplexPairs exact = compare(point, x, tally);
      if (k % 5 == 0)
        check_reference(point, exact, x);
      Eigen::Index loudest;
      const double rate = exact.lambda.real().maxCoeff(&loudest);
      if (unstable == 0. && k > 0 && rate > 0. && last_rate <= 0.)
        {
          unstable = x;
          stable   = x - .1;
          growing  = exact.lambda[loudest];
        }
      last_rate = rate;
    }
  check(unstable > 0., "the scan meets an instability");
  const double x0 = lock_in(stable, unstable, growing);
  for (int k = 0; k < 10; ++k)
    {
      const double x = x0 + (k - 4.5) * 2e-5;
      compare(Point(x), x, tally);
    }
  check(tally.n_compared > 30,
        "errors above 1e-10: " + std::to_string(tally.n_compared) + " of " +
          std::to_string(tally.n_pairs));
  check(tally.n_outside == 0,
        "estimates within a factor 3 of the true errors: all but " +
          std::to_string(tally.n_outside) + ", ratios from " +
          number(tally.ratio.smallest()) + " to " +
          number(tally.ratio.largest()));
  return 0;
}
