// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/dense_products.h>
#include <squeal/base/exceptions.h>
#include <squeal/eigen/dense_scaling.h>
#include <squeal/eigen/shifted_hessenberg.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace squeal
{
  namespace
  {
    using Complex = std::complex<double>;
  } // namespace



  ShiftedHessenberg::ShiftedHessenberg(const Eigen::MatrixXd &K,
                                       const Eigen::MatrixXd &M,
                                       const double           highest)
  {
    // Eigen's decompositions ask for one unknown at least.
    if (M.rows() == 0)
      return;
    if (Eigen::LLT<Eigen::MatrixXd>(M).info() != Eigen::Success)
      throw ComputationError("the mass matrix of a reduced model is not "
                             "positive definite");
    kappa_0 = typical_kappa(K, M, least_kappa(highest));
    const Eigen::MatrixXd                      A = K + kappa_0 * M;
    const Eigen::VectorXd                      D = unit_diagonal_scales(A);
    const Eigen::PartialPivLU<Eigen::MatrixXd> inverse(D.asDiagonal() * A *
                                                       D.asDiagonal());
    const Eigen::HessenbergDecomposition<Eigen::MatrixXd> hessenberg(
      inverse.solve(Eigen::MatrixXd(D.asDiagonal() * M * D.asDiagonal())));
    const Eigen::MatrixXd Q = hessenberg.matrixQ();
    H                       = hessenberg.matrixH();
    after                   = D.asDiagonal() * Q;
    before = Q.transpose() * inverse.solve(Eigen::MatrixXd(D.asDiagonal()));
  }

  ShiftedHessenberg::Factor
  ShiftedHessenberg::factor(const Complex s) const
  {
    return Factor(*this, s);
  }

  ShiftedHessenberg::Factor::Factor(const ShiftedHessenberg &o, const Complex s)
    : owner(o)
    , U((s - o.kappa_0) * o.H.cast<Complex>())
    , factors(Eigen::VectorXcd::Zero(o.H.rows()))
    , exchanged(o.H.rows(), false)
  {
    U.diagonal().array() += 1.;
    if (U.rows() == 0)
      return;
    // Squares throughout: moduli would cost as much as the elimination. A
    // matrix of zeros has no size: its smallest pivot has an inverse and a
    // square.
    const double least = std::max(std::numeric_limits<double>::epsilon() *
                                    std::sqrt(U.cwiseAbs2().maxCoeff()),
                                  1e-100);
    const auto   keep_away_from_zero = [&](Complex &pivot) {
      if (std::norm(pivot) < least * least)
        pivot = least;
    };
    for (Eigen::Index k = 0; k + 1 < U.rows(); ++k)
      {
        const Eigen::Index rest = U.cols() - k;
        exchanged[k]            = std::norm(U(k + 1, k)) > std::norm(U(k, k));
        if (exchanged[k])
          U.row(k).tail(rest).swap(U.row(k + 1).tail(rest));
        keep_away_from_zero(U(k, k));
        factors[k] = U(k + 1, k) / U(k, k);
        U.row(k + 1).tail(rest) -= factors[k] * U.row(k).tail(rest);
      }
    keep_away_from_zero(U(U.rows() - 1, U.cols() - 1));
  }

  Eigen::MatrixXcd
  ShiftedHessenberg::Factor::solve(const Eigen::MatrixXcd &B) const
  {
    Eigen::MatrixXcd X = times(owner.before, B);
    for (Eigen::Index k = 0; k + 1 < U.rows(); ++k)
      {
        if (exchanged[k])
          X.row(k).swap(X.row(k + 1));
        X.row(k + 1) -= factors[k] * X.row(k);
      }
    U.triangularView<Eigen::Upper>().solveInPlace(X);
    return times(owner.after, X);
  }

  Eigen::MatrixXcd
  ShiftedHessenberg::Factor::solve_transposed(const Eigen::MatrixXcd &B) const
  {
    Eigen::MatrixXcd X = transpose_times(owner.after, B);
    U.transpose().triangularView<Eigen::Lower>().solveInPlace(X);
    for (Eigen::Index k = U.rows() - 2; k >= 0; --k)
      {
        X.row(k) -= factors[k] * X.row(k + 1);
        if (exchanged[k])
          X.row(k).swap(X.row(k + 1));
      }
    return transpose_times(owner.before, X);
  }
} // namespace squeal
