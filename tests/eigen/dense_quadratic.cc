// SPDX-License-Identifier: LGPL-2.1-or-later

// Small quadratic pencils against closed forms, and left and right vectors
// against the pencil itself.

#include "check.h"
#include "worst.h"

#include <squeal/eigen/dense_quadratic_of_band.h>

#include <Eigen/Dense>

using namespace squeal;
using squeal::testing::check;

namespace
{
  using Complex = std::complex<double>;

  struct Matrices
  {
    Eigen::MatrixXd M, C, K;
    double          loss = 0.; /**< K (1 + i loss) */
  };

  DensePairs
  solve(const Matrices &m,
        const bool      rayleigh = false,
        const double    alpha    = 0.,
        const double    beta     = 0.)
  {
    return solve_dense_quadratic(
      {{m.M, {1., 0., 0.}}, {m.C, {0., 1., 0.}}, {m.K, {0., 0., {1., m.loss}}}},
      rayleigh,
      alpha,
      beta);
  }

  Matrices
  one_dof(const double m, const double c, const double k)
  {
    return {Eigen::MatrixXd::Constant(1, 1, m),
            Eigen::MatrixXd::Constant(1, 1, c),
            Eigen::MatrixXd::Constant(1, 1, k)};
  }

  void
  check_lambda(const Complex a, const Complex b, const std::string &text)
  {
    check(std::abs(a - b) <= 1e-13 * std::abs(b), text);
  }

  void
  check_vectors(const Matrices    &m,
                const DensePairs  &pairs,
                const std::string &text)
  {
    const Complex i(0., 1.);
    for (Eigen::Index k = 0; k < pairs.lambda.size(); ++k)
      {
        const Complex          l = pairs.lambda[k];
        const Eigen::MatrixXcd Q = l * l * m.M.cast<Complex>() +
                                   l * m.C.cast<Complex>() +
                                   (1. + i * m.loss) * m.K.cast<Complex>();
        const double size =
          std::norm(l) * m.M.norm() + std::abs(l) * m.C.norm() + m.K.norm();
        check((Q * pairs.right.col(k)).norm() < 1e-12 * size,
              text + ": Q x = 0");
        check((pairs.left.col(k).transpose() * Q).norm() < 1e-12 * size,
              text + ": y^T Q = 0");
      }
  }

  /** Of free motions, whose stiffness is rounding, and of pairs up to 10 krad/s
   * with lambda^2 + c lambda + kappa = 0. */
  void
  test_free_motions(const Eigen::Index n_free, const double c)
  {
    constexpr double   highest = 1e4;
    const Eigen::Index n = 14, n_pairs = n - n_free;
    Matrices           m{Eigen::MatrixXd::Identity(n, n),
               Eigen::MatrixXd::Zero(n, n),
               1e-7 * Eigen::MatrixXd::Random(n, n)};
    m.K.diagonal().head(n_free).setConstant(2e-7);
    for (Eigen::Index i = 0; i < n_pairs; ++i)
      {
        m.K(n_free + i, n_free + i) = 1e7 * (1. + .5 * i);
        m.C(n_free + i, n_free + i) = c;
      }
    const DensePairs pairs = solve_dense_quadratic_of_band(
      {{m.M, {1., 0., 0.}}, {m.C, {0., 1., 0.}}, {m.K, {0., 0., 1.}}},
      c == 0.,
      0.,
      0.,
      highest);
    squeal::testing::Worst off;
    for (Eigen::Index i = 0; i < n_pairs; ++i)
      {
        const double  kappa = 1e7 * (1. + .5 * i);
        const Complex exact(-.5 * c, std::sqrt(kappa - .25 * c * c));
        off.add(
          (pairs.lambda.array() - exact).abs().minCoeff<Eigen::PropagateNaN>() /
          std::abs(exact));
      }
    check_within(
      off, 1e-11, "pairs beside " + std::to_string(n_free) + " free motions");
  }

  void
  test_one_dof()
  {
    const double m = 2., k = 50., c = 3.;
    const double omega = std::sqrt(k / m - c * c / (4. * m * m));
    DensePairs   pairs = solve(one_dof(m, c, k));
    check(pairs.lambda.size() == 1, "one of a conjugate pair");
    check_lambda(pairs.lambda[0], {-c / (2. * m), omega}, "damped oscillator");

    pairs             = solve(one_dof(m, 40., k));
    const double root = std::sqrt(1600. - 4. * m * k);
    check(pairs.lambda.size() == 2, "both overdamped motions");
    check_lambda(pairs.lambda[0], (-40. - root) / (2. * m), "fast decay");
    check_lambda(pairs.lambda[1], (-40. + root) / (2. * m), "slow decay");

    pairs = solve(one_dof(m, 0., -k));
    check(pairs.lambda.size() == 2, "divergence: two real eigenvalues");
    check_lambda(pairs.lambda[1], std::sqrt(k / m), "divergence");

    Matrices lossy = one_dof(m, 0., k);
    lossy.loss     = 0.02;
    pairs          = solve(lossy);
    check(pairs.lambda.size() == 1, "one eigenvalue with structural damping");
    check_lambda(pairs.lambda[0],
                 Complex(0., 1.) * std::sqrt(k / m * Complex(1., 0.02)),
                 "structural damping");
    check(pairs.lambda[0].real() < 0., "structural damping damps");
  }

  void
  test_two_dof_flutter()
  {
    // K = [[2, 1 - 4 mu / 3], [1, 2]], M = I, mu = 1.
    Matrices m{Eigen::MatrixXd::Identity(2, 2),
               Eigen::MatrixXd::Zero(2, 2),
               Eigen::MatrixXd::Constant(2, 2, 2.)};
    m.K(1, 0)      = 1.;
    m.K(0, 1)      = -1. / 3.;
    const double a = 2., b2 = 1. / 3.;
    const double sigma = std::sqrt((std::sqrt(a * a + b2) - a) / 2.),
                 omega = std::sqrt((std::sqrt(a * a + b2) + a) / 2.);
    check(std::abs(sigma - 0.2020718) < 1e-7, "published growth rate");
    for (const bool rayleigh : {false, true})
      {
        const DensePairs pairs = solve(m, rayleigh);
        check(pairs.lambda.size() == 2, "both members of the coalesced pair");
        // Equal but for rounding in frequency: their order is open.
        const int growing = pairs.lambda[1].real() > 0. ? 1 : 0;
        check_lambda(pairs.lambda[1 - growing], {-sigma, omega}, "decaying");
        check_lambda(pairs.lambda[growing], {sigma, omega}, "growing");
        check_vectors(m, pairs, "flutter");
      }
  }

  void
  test_rayleigh_is_companion()
  {
    const int       n = 7;
    Eigen::MatrixXd A = Eigen::MatrixXd::Random(n, n);
    Matrices        m;
    m.M = A.transpose() * A + Eigen::MatrixXd::Identity(n, n);
    A   = Eigen::MatrixXd::Random(n, n);
    m.K = 400. * (A.transpose() * A + Eigen::MatrixXd::Identity(n, n));
    m.K += 800. * Eigen::MatrixXd::Random(n, n);
    // The second case has overdamped motions.
    for (const auto &[alpha, beta] : {std::make_pair(.5, 1e-3), {3., .2}})
      {
        m.C          = alpha * m.M + beta * m.K;
        const auto x = solve(m, true, alpha, beta), y = solve(m);
        check(x.lambda.size() == y.lambda.size(), "as many eigenvalues");
        check(x.lambda.size() >= n, "all eigenvalues");
        for (Eigen::Index i = 0; i < x.lambda.size(); ++i)
          {
            testing::Worst nearest;
            for (Eigen::Index j = 0; j < y.lambda.size(); ++j)
              nearest.add(std::abs(x.lambda[i] - y.lambda[j]));
            check(nearest.smallest() < 1e-11 * std::abs(x.lambda[i]) + 1e-10,
                  "Rayleigh damping by the single size and by the companion");
          }
        check_vectors(m, x, "Rayleigh");
        check_vectors(m, y, "companion");
      }
    m.loss = 0.1;
    check_vectors(m, solve(m), "complex stiffness");
  }

  /** Damping of 1e-9 of the frequency is not lost in rounding. */
  void
  test_tiny_damping()
  {
    const double     omega = 1e5, beta = 1e-14;
    const DensePairs pairs =
      solve(one_dof(1., beta * omega * omega, omega * omega), true, 0., beta);
    testing::check_close(pairs.lambda[0].real(),
                         -beta * omega * omega / 2.,
                         1e-12,
                         "tiny Rayleigh damping to full accuracy");
  }
} // namespace



int
main()
{
  test_one_dof();
  test_two_dof_flutter();
  test_rayleigh_is_companion();
  test_tiny_damping();
  for (const Eigen::Index n_free : {1, 3, 6, 12})
    for (const double c : {0., 2.})
      test_free_motions(n_free, c);
  return 0;
}
