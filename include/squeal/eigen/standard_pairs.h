// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_eigen_standard_pairs_h
#define squeal_eigen_standard_pairs_h

#include <Eigen/Core>

namespace squeal
{
  /**
   * All eigenvalues of a dense matrix A with right vectors, A x = mu x, and
   * left ones, w^T A = mu w^T (no conjugation), of 2-norm 1 each. Of a real
   * matrix conjugates follow one another, the one with the positive imaginary
   * part first.
   *
   * Each vector satisfies its own equation to rounding, also where two
   * eigenvalues coalesce and their vectors become parallel; w^T x is zero
   * there.
   */
  struct StandardPairs
  {
    Eigen::VectorXcd values;
    Eigen::MatrixXcd right, left;
    /** |w^T x| over |w| |x| of the balanced matrix: one over the condition of
     * the eigenvalue; 1 of a normal matrix, 0 at a coalescence. */
    Eigen::VectorXd reciprocal_condition;
  };

  /** By LAPACK's expert driver (dgeevx, zgeevx), which permutes and scales A
   * before it reduces it. Throws ComputationError where A holds a number that
   * is not finite or the iteration does not converge. */
  StandardPairs standard_pairs(Eigen::MatrixXd A);
  StandardPairs standard_pairs(Eigen::MatrixXcd A);

  /** The eigenvalues alone, in no order. */
  Eigen::VectorXcd standard_values(Eigen::MatrixXcd A);
} // namespace squeal

#endif
