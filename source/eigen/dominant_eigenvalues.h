// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_eigen_dominant_eigenvalues_h
#define squeal_eigen_dominant_eigenvalues_h

#include <squeal/base/row_space.h>

#include <functional>

namespace squeal
{
  /** A product with a matrix of 2 N rows; of a vector each rank has its rows of
   * the first half, then those of the second. */
  using LinearStep = std::function<Eigen::VectorXcd(const Eigen::VectorXcd &)>;

  /**
   * The @p most eigenvalues of a step of largest size with their vectors (one a
   * column), by PARPACK's znaupd or, where these are all or all but one, as a
   * dense matrix; zeros, which stand for infinite lambda, are then left out.
   * @p shift_size is |shift|, 1/s, of the step, whose eigenvalues are
   * 1 / (lambda - shift). Throws ComputationError where ARPACK does not
   * converge.
   */
  void dominant_eigenvalues(const LinearStep  &apply,
                            const RowSpace    &space,
                            const unsigned int most,
                            const double       tolerance,
                            const double       shift_size,
                            Eigen::VectorXcd  &values,
                            Eigen::MatrixXcd  &vectors);
} // namespace squeal

#endif
