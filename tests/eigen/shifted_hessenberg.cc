// SPDX-License-Identifier: LGPL-2.1-or-later

// (K + s M) Z = B for many shifts against a factorisation of each.

#include "worst.h"

#include <squeal/base/exceptions.h>
#include <squeal/eigen/shifted_hessenberg.h>

#include <Eigen/Dense>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  using Complex = std::complex<double>;

  Eigen::MatrixXd
  some_mass(const Eigen::Index n)
  {
    const Eigen::MatrixXd A = Eigen::MatrixXd::Random(n, n);
    return A.transpose() * A + .1 * Eigen::MatrixXd::Identity(n, n);
  }

  void
  test_shifts(const Eigen::Index n)
  {
    const Eigen::MatrixXd   K = Eigen::MatrixXd::Random(n, n), M = some_mass(n);
    const ShiftedHessenberg solver(K, M);
    Worst                   worst;
    for (const Complex s : {Complex(0., 0.),
                            Complex(2., 0.),
                            Complex(-.3, 1.),
                            Complex(0., -1e6),
                            Complex(1e-9, 1e-9)})
      for (const Eigen::Index columns : {1, 2, 5})
        {
          const Eigen::MatrixXcd A = K.cast<Complex>() + s * M.cast<Complex>();
          const Eigen::MatrixXcd B = Eigen::MatrixXcd::Random(n, columns);
          const auto             factor = solver.factor(s);
          const Eigen::MatrixXcd x      = factor.solve(B),
                                 y      = factor.solve_transposed(B);
          const auto relative           = [&](const Eigen::MatrixXcd &r,
                                    const Eigen::MatrixXcd &z) {
            return r.norm() / (A.norm() * z.norm() + B.norm());
          };
          worst.add(relative(A * x - B, x), "solve");
          worst.add(relative(A.transpose() * y - B, y), "transposed");
        }
    // Elimination on condition 100 of M, both sides.
    check_within(worst, 1e-12, std::to_string(n) + " unknowns");
  }

  /** At an eigenvalue the solution is huge, finite and along its vector. */
  void
  test_singular()
  {
    Eigen::MatrixXd K(3, 3), M = Eigen::MatrixXd::Identity(3, 3);
    K << 2., 1., 0., 1., 2., 1., 0., 1., 2.;
    const ShiftedHessenberg solver(K, M);
    const double            mu     = 2. + std::sqrt(2.);
    const Eigen::MatrixXcd  B      = Eigen::MatrixXcd::Ones(3, 1);
    const auto              factor = solver.factor(-mu);
    Eigen::VectorXcd        expected(3);
    expected << .5, std::sqrt(.5), .5;
    for (const bool transposed : {false, true})
      {
        const Eigen::VectorXcd x =
          transposed ? factor.solve_transposed(B) : factor.solve(B);
        check(x.allFinite() && x.norm() > 1e10, "huge at an eigenvalue");
        check(std::abs(std::abs(expected.dot(x)) / x.norm() - 1.) <= 1e-10,
              "along its vector");
      }
    // All pivots vanish.
    const ShiftedHessenberg zero(Eigen::MatrixXd::Zero(3, 3), M);
    check(zero.factor(0.).solve(B).allFinite() &&
            zero.factor(0.).solve_transposed(B).allFinite(),
          "finite where the matrix is zero");
  }

  /** Directions of a stiff contact, 1e18 above the others and coupled with
   * them, against Gaussian elimination with more digits. */
  void
  test_stiff_directions()
  {
    using Long       = std::complex<long double>;
    using LongMatrix = Eigen::Matrix<Long, Eigen::Dynamic, Eigen::Dynamic>;
    const Eigen::Index    n = 12, n_stiff = 4;
    const Eigen::MatrixXd A = Eigen::MatrixXd::Random(n, n);
    Eigen::VectorXd       size(n);
    size << Eigen::VectorXd::Ones(n - n_stiff),
      Eigen::VectorXd::Constant(n_stiff, 1e9);
    const Eigen::MatrixXd K = size.asDiagonal() *
                              (A + 4. * Eigen::MatrixXd::Identity(n, n)) *
                              size.asDiagonal(),
                          M = some_mass(n);
    const ShiftedHessenberg solver(K, M);
    const Eigen::MatrixXcd  B = Eigen::MatrixXcd::Random(n, 3);
    Worst                   worst;
    for (const Complex s :
         {Complex(-.5, .2), Complex(-2., 0.), Complex(3., 1.)})
      {
        const LongMatrix Q    = K.cast<Long>() + Long(s) * M.cast<Long>();
        const auto       soft = [&](const LongMatrix &Z) {
          return Eigen::MatrixXcd(Z.cast<Complex>().topRows(n - n_stiff));
        };
        const auto factor = solver.factor(s);
        for (const bool transposed : {false, true})
          {
            const LongMatrix exact =
              Eigen::PartialPivLU<LongMatrix>(
                transposed ? LongMatrix(Q.transpose()) : Q)
                .solve(B.cast<Long>());
            const Eigen::MatrixXcd x =
              transposed ? factor.solve_transposed(B) : factor.solve(B);
            worst.add((soft(x.cast<Long>()) - soft(exact)).norm() /
                        soft(exact).norm(),
                      transposed ? "transposed" : "solve");
          }
      }
    check_within(worst, 1e-11, "beside directions 1e18 times as stiff");
  }

  /** Free motions, whose stiffness is rounding, before directions of a band;
   * against Gaussian elimination with more digits. */
  void
  test_free_motions(const Eigen::Index n_free)
  {
    using Long           = std::complex<long double>;
    using LongMatrix     = Eigen::Matrix<Long, Eigen::Dynamic, Eigen::Dynamic>;
    const Eigen::Index n = 14, n_soft = n - n_free;
    Eigen::MatrixXd    K = 1e-7 * Eigen::MatrixXd::Random(n, n),
                    M    = Eigen::MatrixXd::Identity(n, n);
    K.diagonal().head(n_free).setConstant(2e-7);
    auto soft = K.bottomRightCorner(n_soft, n_soft);
    soft      = 1e5 * Eigen::MatrixXd::Random(n_soft, n_soft);
    for (Eigen::Index i = 0; i < n_soft; ++i)
      soft(i, i) = 1e7 * (1. + i);
    M += .02 * (M * 2. + Eigen::MatrixXd::Ones(n, n));
    const ShiftedHessenberg solver(K, M, 1e4);
    const Eigen::MatrixXcd  B = Eigen::MatrixXcd::Random(n, 3);
    Worst                   worst;
    for (const Complex s : {Complex(-1.01e7, 1e4), Complex(-6e6, 0.)})
      {
        const LongMatrix Q      = K.cast<Long>() + Long(s) * M.cast<Long>();
        const auto       factor = solver.factor(s);
        for (const bool transposed : {false, true})
          {
            const Eigen::MatrixXcd exact =
              Eigen::PartialPivLU<LongMatrix>(
                transposed ? LongMatrix(Q.transpose()) : Q)
                .solve(B.cast<Long>())
                .cast<Complex>();
            const Eigen::MatrixXcd x =
              transposed ? factor.solve_transposed(B) : factor.solve(B);
            worst.add((x - exact).norm() / exact.norm(),
                      transposed ? "transposed" : "solve");
          }
      }
    check_within(
      worst, 1e-10, "beside " + std::to_string(n_free) + " free motions");
  }

  void
  test_refusals()
  {
    const Eigen::MatrixXd K = Eigen::MatrixXd::Identity(2, 2);
    Eigen::MatrixXd       M(2, 2);
    M << 1., 2., 2., 1.;
    check_throws<ComputationError>([&] { ShiftedHessenberg(K, M); },
                                   "not positive definite",
                                   "an indefinite mass is refused");
    const Eigen::MatrixXd   none(0, 0);
    const ShiftedHessenberg empty(none, none);
    check(empty.factor(1.).solve(Eigen::MatrixXcd(0, 2)).cols() == 2,
          "no unknowns");
  }
} // namespace



int
main()
{
  for (const Eigen::Index n : {1, 2, 3, 20})
    test_shifts(n);
  test_singular();
  test_stiff_directions();
  for (const Eigen::Index n_free : {1, 3, 6, 12})
    test_free_motions(n_free);
  test_refusals();
}
