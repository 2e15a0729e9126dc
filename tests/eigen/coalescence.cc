// SPDX-License-Identifier: LGPL-2.1-or-later

// At lock-in, where two eigenvalues and their vectors become one, and at
// distances of 1e-4 to 1e-14 from it: left and right vectors satisfy their
// equations to rounding, conditions are finite, mean and squared
// half-difference of the pair are those of the closed form.

#include "check.h"

#include <squeal/base/exceptions.h>
#include <squeal/eigen/certified_solver.h>
#include <squeal/eigen/dense_quadratic.h>
#include <squeal/eigen/eigenvalue_condition.h>
#include <squeal/eigen/standard_pairs.h>

#include <Eigen/Dense>

#include <limits>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  using Complex = std::complex<double>;

  constexpr double eps = std::numeric_limits<double>::epsilon();

  const std::vector<double> distances{1e-4,
                                      -1e-4,
                                      1e-6,
                                      -1e-6,
                                      1e-8,
                                      -1e-8,
                                      1e-10,
                                      1e-12,
                                      -1e-12,
                                      1e-14,
                                      0.};

  std::string
  at(const double distance)
  {
    char text[40];
    std::snprintf(text, sizeof(text), ", %g from lock-in", distance);
    return text;
  }

  /** Every vector in its own equation: the residual over |A| |x|. */
  template <typename Matrix>
  void
  check_residuals(const Matrix        &A,
                  const StandardPairs &pairs,
                  const std::string   &text)
  {
    for (Eigen::Index k = 0; k < pairs.values.size(); ++k)
      {
        const Eigen::VectorXcd x = pairs.right.col(k), w = pairs.left.col(k);
        const Eigen::VectorXcd of_x = A * x - pairs.values[k] * x;
        const Eigen::VectorXcd of_w = A.transpose() * w - pairs.values[k] * w;
        check(of_x.norm() <= 20. * eps * A.norm() * x.norm(),
              text + ": A x = mu x");
        check(of_w.norm() <= 20. * eps * A.norm() * w.norm(),
              text + ": w^T A = mu w^T");
        check(std::abs(x.norm() - 1.) < 1e-14 &&
                std::abs(w.norm() - 1.) < 1e-14,
              text + ": vectors of size 1");
        const double r = pairs.reciprocal_condition[k];
        check(r >= 0. && r <= 1. + 1e-14, text + ": a condition of 1 or more");
      }
  }

  void
  test_standard_pairs()
  {
    for (const double d : distances)
      {
        Eigen::MatrixXd A(2, 2);
        A << 2., d, 1., 2.;
        check_residuals(A, standard_pairs(A), "2 x 2" + at(d));
        const Eigen::MatrixXcd B = A.cast<Complex>() * Complex(1., .1);
        check_residuals(B, standard_pairs(B), "complex 2 x 2" + at(d));
        // cos of the angle between left and right: 2 sqrt(d) / (1 + d)
        const double r = standard_pairs(A).reciprocal_condition[0];
        const double expected =
          2. * std::sqrt(std::abs(d)) / (1. + std::abs(d));
        if (std::abs(d) >= 1e-10)
          check(std::abs(r / expected - 1.) < 1e-4,
                "condition in closed form" + at(d));
        else
          check(r <= 1e-4, "condition of a coalesced pair" + at(d));
      }
    check(standard_pairs(Eigen::MatrixXd(0, 0)).values.size() == 0,
          "no unknowns, no pairs");
    Eigen::MatrixXd symmetric = Eigen::MatrixXd::Random(6, 6);
    symmetric += symmetric.transpose().eval();
    const StandardPairs of_symmetric = standard_pairs(symmetric);
    check_residuals(symmetric, of_symmetric, "symmetric");
    check((of_symmetric.reciprocal_condition.array() - 1.)
              .abs()
              .maxCoeff<Eigen::PropagateNaN>() < 1e-12,
          "a symmetric matrix has conditions of 1");
    const Eigen::MatrixXd any = Eigen::MatrixXd::Random(7, 7);
    check_residuals(any, standard_pairs(any), "any");
    Eigen::MatrixXd wrong = any;
    wrong(3, 2)           = std::numeric_limits<double>::quiet_NaN();
    check_throws<ComputationError>([&] { standard_pairs(wrong); },
                                   "not finite",
                                   "a matrix with NaN is refused");
  }

  /** States in units 16 decades apart lose no digits: balancing. */
  void
  test_balancing()
  {
    Eigen::MatrixXd A(3, 3);
    A << 1., 2., .5, -1., 3., .25, .5, .75, -2.;
    Eigen::VectorXd units(3);
    units << 1., 1e8, 1e-8;
    const auto expected = standard_pairs(A).values;
    const auto found    = standard_pairs(Eigen::MatrixXd(
      units.asDiagonal() * A * units.cwiseInverse().asDiagonal()));
    for (const Complex mu : expected)
      {
        const double away =
          (found.values.array() - mu).abs().minCoeff<Eigen::PropagateNaN>();
        check(away < 1e-13 * std::abs(mu), "eigenvalues in any units");
      }
  }

  /** Hoffmann's two masses, K = [[2, c], [1, 2]] and M = 1 with lock-in at
   * c = 0, in other coordinates and in (rad/s)^2. */
  struct Hoffmann
  {
    explicit Hoffmann(const double c)
    {
      Eigen::Matrix2d k, P;
      k << 2., c, 1., 2.;
      P << .8, .3, -.4, 1.1;
      M = P.transpose() * P;
      K = unit * P.transpose() * k * P;
    }

    const double    unit = 1e8;
    Eigen::MatrixXd M, K;
  };

  void
  check_pencil(const Hoffmann &h, const DensePairs &pairs, const double c)
  {
    check(pairs.lambda.size() == 2, "both members" + at(c));
    const double floor = 1e-13;
    for (int k = 0; k < 2; ++k)
      {
        const Complex          l = pairs.lambda[k];
        const Eigen::MatrixXcd Q =
          l * l * h.M.cast<Complex>() + h.K.cast<Complex>();
        const double           size = std::norm(l) * h.M.norm() + h.K.norm();
        const Eigen::VectorXcd x = pairs.right.col(k), y = pairs.left.col(k);
        check((Q * x).norm() <= floor * size, "Q x = 0" + at(c));
        check((Q.transpose() * y).norm() <= floor * size, "y^T Q = 0" + at(c));
        const double mass_x   = std::sqrt(x.dot(h.M * x).real()),
                     mass_y   = std::sqrt(y.dot(h.M * y).real());
        const Complex product = (y.transpose() * (2. * l * (h.M * x))).value();
        const double  condition =
          eigenvalue_condition(l, mass_x * mass_y, product);
        const double expected =
          (1. + std::abs(c)) / (2. * std::sqrt(std::abs(c)));
        check(std::isfinite(condition), "a finite condition" + at(c));
        if (std::abs(c) >= 1e-10)
          check(std::abs(condition / expected - 1.) < 1e-3,
                "condition in closed form" + at(c));
        else
          check(condition > 1e5 && condition <= 1. / eps,
                "a large condition" + at(c));
      }
    const Complex a = -pairs.lambda[0] * pairs.lambda[0] / h.unit,
                  b = -pairs.lambda[1] * pairs.lambda[1] / h.unit;
    check(std::abs(.5 * (a + b) - 2.) <= 1e-13, "mean of the pair" + at(c));
    check(std::abs(.25 * (a - b) * (a - b) - c) <= 1e-13,
          "squared half-difference of the pair" + at(c));
  }

  void
  test_quadratic()
  {
    for (const double c : distances)
      {
        const Hoffmann h(c);
        check_pencil(
          h,
          solve_dense_quadratic(
            {{h.M, {1., 0., 0.}}, {h.K, {0., 0., 1.}}}, true, 0., 0.),
          c);
        check_pencil(
          h,
          solve_dense_quadratic({{h.M, {1., 0., 0.}},
                                 {Eigen::MatrixXd::Zero(2, 2), {0., 1., 0.}},
                                 {h.K, {0., 0., 1.}}},
                                false,
                                0.,
                                0.),
          c);
      }
  }

  /** The other member of a coalesced pair lies beyond the band. */
  void
  test_lone_member()
  {
    ComplexPairs pairs;
    pairs.lambda    = Eigen::VectorXcd::Constant(1, Complex(0., 1000.));
    pairs.condition = Eigen::VectorXd::Constant(1, 1e6);
    for (const int n : {1, 3})
      {
        Eigen::VectorXcd better(n);
        for (int i = 0; i < n; ++i)
          better[i] = Complex(0., 1000.01 + 500. * i);
        estimate_errors(pairs, better);
        check(std::abs(pairs.error_estimate[0] - 1e-5) <= 1e-12,
              "a lone member of a coalesced pair has an estimate");
        check(pairs.pair_partner[0] == -1, "and no partner");
      }
  }
} // namespace



int
main()
{
  test_standard_pairs();
  test_balancing();
  test_quadratic();
  test_lone_member();
  return 0;
}
