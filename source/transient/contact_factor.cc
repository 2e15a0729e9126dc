// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact_factor.h"

#include <algorithm>
#include <cmath>

namespace squeal
{
  double
  rounding_of_flexibility(const ReducedContactModel &model)
  {
    constexpr double share = 1e-12;
    // Motions that nothing holds count by the shift of the factor.
    const double           softest = std::pow(2. * M_PI * residual_shift, 2);
    const Eigen::MatrixXd &Psi     = model.participation;
    double                 largest = model.flexibility.diagonal().maxCoeff();
    if (Psi.size() > 0)
      largest = std::max(
        largest,
        (Psi.cwiseAbs2() * model.omega_squared.cwiseMax(softest).cwiseInverse())
          .maxCoeff());
    return share * largest;
  }



  ContactFactor::ContactFactor(const Eigen::MatrixXd &flexibility,
                               const double           rounding)
  {
    if (flexibility.size() == 0)
      return;
    factor.emplace(flexibility);
    // Its estimate of the condition is of the norm of columns, which may be
    // that much larger.
    const double norm = flexibility.cwiseAbs().colwise().sum().maxCoeff();
    // Beside a pivot of zero that estimate is no number, or any.
    const bool has_pivots =
      (factor->matrixLU().diagonal().array().abs() > rounding).all();
    if (has_pivots &&
        factor->rcond() * norm > 10. * flexibility.rows() * rounding)
      return;
    const Eigen::BDCSVD<Eigen::MatrixXd> parts(
      flexibility, Eigen::ComputeFullU | Eigen::ComputeFullV);
    const Eigen::Index n_left =
      (parts.singularValues().array() <= rounding).count();
    if (n_left == 0)
      return;
    factor.reset();
    const Eigen::Index rank = flexibility.rows() - n_left;
    inverse                 = parts.matrixV().leftCols(rank) *
              parts.singularValues().head(rank).cwiseInverse().asDiagonal() *
              parts.matrixU().leftCols(rank).transpose();
    left  = parts.matrixU().rightCols(n_left);
    right = parts.matrixV().rightCols(n_left);
  }

  bool
  ContactFactor::is_regular() const
  {
    return right.cols() == 0;
  }

  Eigen::MatrixXd
  ContactFactor::solve(const Eigen::MatrixXd &motions) const
  {
    if (motions.rows() == 0)
      return motions;
    return factor ? Eigen::MatrixXd(factor->solve(motions))
                  : Eigen::MatrixXd(inverse * motions);
  }

  const Eigen::MatrixXd &
  ContactFactor::left_null_space() const
  {
    return left;
  }

  const Eigen::MatrixXd &
  ContactFactor::null_space() const
  {
    return right;
  }
} // namespace squeal
