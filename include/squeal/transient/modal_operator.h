// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_transient_modal_operator_h
#define squeal_transient_modal_operator_h

#include <Eigen/Core>

#include <utility>

namespace squeal
{
  /** A linear map of modal coordinates: one factor for each mode, or a matrix
   * where modes are coupled. */
  class ModalOperator
  {
  public:
    ModalOperator() = default;
    explicit ModalOperator(Eigen::VectorXd factors)
      : factors(std::move(factors))
    {
    }
    explicit ModalOperator(Eigen::MatrixXd coupled)
      : matrix(std::move(coupled))
    {
    }

    Eigen::VectorXd
    operator*(const Eigen::VectorXd &x) const
    {
      if (is_coupled())
        return matrix * x;
      return factors.cwiseProduct(x);
    }
    /** Column by column. */
    Eigen::MatrixXd
    operator*(const Eigen::MatrixXd &x) const
    {
      if (is_coupled())
        return matrix * x;
      return factors.asDiagonal() * x;
    }

  private:
    bool
    is_coupled() const
    {
      return matrix.size() > 0;
    }

    Eigen::VectorXd factors;
    Eigen::MatrixXd matrix;
  };
} // namespace squeal

#endif
