// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_base_dense_products_h
#define squeal_base_dense_products_h

#include <Eigen/Dense>

namespace squeal
{
  /** A Z with a real A and a complex Z, by one real product: half the work of
   * the complex one, and it goes through BLAS. */
  inline Eigen::MatrixXcd
  times(const Eigen::Ref<const Eigen::MatrixXd> &A, const Eigen::MatrixXcd &Z)
  {
    Eigen::MatrixXd both(Z.rows(), 2 * Z.cols());
    both << Z.real(), Z.imag();
    const Eigen::MatrixXd product = A * both;
    Eigen::MatrixXcd      result(A.rows(), Z.cols());
    result.real() = product.leftCols(Z.cols());
    result.imag() = product.rightCols(Z.cols());
    return result;
  }

  /** A^T Z. */
  inline Eigen::MatrixXcd
  transpose_times(const Eigen::Ref<const Eigen::MatrixXd> &A,
                  const Eigen::MatrixXcd                  &Z)
  {
    Eigen::MatrixXd both(Z.rows(), 2 * Z.cols());
    both << Z.real(), Z.imag();
    const Eigen::MatrixXd product = A.transpose() * both;
    Eigen::MatrixXcd      result(A.cols(), Z.cols());
    result.real() = product.leftCols(Z.cols());
    result.imag() = product.rightCols(Z.cols());
    return result;
  }
} // namespace squeal

#endif
