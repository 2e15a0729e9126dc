// SPDX-License-Identifier: LGPL-2.1-or-later

// The direct solver against dense algebra, the inertia against known
// signatures.

#include "check.h"

#include <squeal/base/exceptions.h>
#include <squeal/base/mumps.h>

#include <deal.II/base/mpi.h>

#include <Eigen/Dense>

#include <limits>

using namespace squeal;
using squeal::testing::check;

namespace
{
  constexpr int n = 12;

  template <typename Number>
  struct Entries
  {
    std::vector<int>    rows, columns;
    std::vector<Number> values;

    /** Every entry in two pieces: duplicates are to be summed. */
    explicit Entries(
      const Eigen::Matrix<Number, Eigen::Dynamic, Eigen::Dynamic> &A,
      const bool                                                   lower_only)
    {
      for (int i = 0; i < A.rows(); ++i)
        for (int j = 0; j < (lower_only ? i + 1 : A.cols()); ++j)
          if (A(i, j) != Number(0.))
            for (const double part : {0.25, 0.75})
              {
                rows.push_back(i);
                columns.push_back(j);
                values.push_back(part * A(i, j));
              }
    }
  };

  template <typename Number>
  void
  test_general()
  {
    using Matrix = Eigen::Matrix<Number, Eigen::Dynamic, Eigen::Dynamic>;
    const auto                 space = std::make_shared<RowSpace>(n);
    MumpsFactorization<Number> factor(
      space, MumpsFactorization<Number>::Symmetry::general);
    Matrix       A = Matrix::Random(n, n) + 2. * Matrix::Identity(n, n);
    const Matrix b = Matrix::Random(n, 5);
    for (const bool again : {false, true})
      {
        if (again)
          A = Matrix::Random(n, n) - 3. * Matrix::Identity(n, n);
        Entries<Number> e(A, false);
        if (again)
          factor.refactorize(e.values);
        else
          factor.factorize(e.rows, e.columns, e.values, true);
        check((A * factor.solve(b) - b).norm() < 1e-12 * b.norm(), "A x = b");
        check((A.transpose() * factor.solve_transposed(b) - b).norm() <
                1e-12 * b.norm(),
              "A^T x = b");
      }
    check(factor.solve(Matrix(n, 0)).cols() == 0, "no right-hand side");
  }

  void
  test_inertia()
  {
    // Q D Q^T with known signs, and a saddle point whose zero block adds one
    // negative eigenvalue a multiplier.
    const Eigen::MatrixXd Q =
      Eigen::HouseholderQR<Eigen::MatrixXd>(Eigen::MatrixXd::Random(n, n))
        .householderQ();
    const Eigen::MatrixXd      b     = Eigen::MatrixXd::Random(n, 3);
    const auto                 space = std::make_shared<RowSpace>(n);
    MumpsFactorization<double> factor(
      space, MumpsFactorization<double>::Symmetry::symmetric);
    for (int n_negative = 0; n_negative <= n; ++n_negative)
      {
        Eigen::VectorXd d = Eigen::VectorXd::LinSpaced(n, 1., 5.);
        d.head(n_negative) *= -1.;
        const Eigen::MatrixXd A = Q * d.asDiagonal() * Q.transpose();
        Entries<double>       e(A, true);
        if (n_negative == 0)
          factor.factorize(e.rows, e.columns, e.values, true);
        else
          factor.refactorize(e.values);
        check((A * factor.solve(b) - b).norm() < 1e-12 * b.norm(),
              "LDL^T solves");
        check(factor.n_negative_pivots() == unsigned(n_negative),
              std::to_string(n_negative) + " negative eigenvalues counted");
      }

    Eigen::MatrixXd A = Eigen::MatrixXd::Zero(n, n);
    A.diagonal().head(n - 3).setConstant(2.);
    for (int k = 0; k < 3; ++k)
      A(n - 3 + k, 2 * k) = A(2 * k, n - 3 + k) = 1.;
    MumpsFactorization<double> saddle(
      space, MumpsFactorization<double>::Symmetry::symmetric);
    Entries<double> e(A, true);
    saddle.factorize(e.rows, e.columns, e.values);
    check((A * saddle.solve(b) - b).norm() < 1e-12 * b.norm(),
          "a saddle point is solved");
    check(saddle.n_negative_pivots() == 3,
          "a saddle point has one negative pivot a multiplier");

    Eigen::MatrixXd            singular = Eigen::MatrixXd::Zero(n, n);
    MumpsFactorization<double> broken(
      space, MumpsFactorization<double>::Symmetry::symmetric);
    singular.diagonal().head(n - 1).setOnes();
    Entries<double> s(singular, true);
    s.rows.push_back(n - 1);
    s.columns.push_back(n - 1);
    s.values.push_back(0.);
    testing::check_throws<ComputationError>(
      [&] { broken.factorize(s.rows, s.columns, s.values); },
      "singular",
      "a singular matrix is refused");
  }

  /** MUMPS would end the program. */
  template <typename Number>
  void
  test_numbers_that_overflow()
  {
    using Matrix = Eigen::Matrix<Number, Eigen::Dynamic, Eigen::Dynamic>;
    MumpsFactorization<Number> factor(
      std::make_shared<RowSpace>(n),
      MumpsFactorization<Number>::Symmetry::general);
    for (const double value : {1e302,
                               std::numeric_limits<double>::infinity(),
                               std::numeric_limits<double>::quiet_NaN()})
      {
        Matrix          A = Matrix::Identity(n, n);
        Entries<Number> good(A, false);
        factor.factorize(good.rows, good.columns, good.values, true);
        A(3, 3) = value;
        Entries<Number> bad(A, false);
        testing::check_throws<InputError>(
          [&] { factor.refactorize(bad.values); },
          "beyond 1e300",
          "a value of " + std::to_string(value) + " is refused anew");
        testing::check_throws<InputError>(
          [&] { factor.factorize(bad.rows, bad.columns, bad.values); },
          "beyond 1e300",
          "a value of " + std::to_string(value) + " is refused");
      }
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize init(argc, argv, 1);
  test_general<double>();
  test_general<std::complex<double>>();
  test_inertia();
  test_numbers_that_overflow<double>();
  test_numbers_that_overflow<std::complex<double>>();
  return 0;
}
