// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_eigen_shifted_hessenberg_h
#define squeal_eigen_shifted_hessenberg_h

#include <Eigen/Core>

#include <complex>
#include <vector>

namespace squeal
{
  /**
   * Solves (K + s M) Z = B for one pair of small dense matrices and many shifts
   * s: after one reduction to Hessenberg form, n^3 real operations, each shift
   * takes n^2.
   */
  class ShiftedHessenberg
  {
  public:
    /** @p M symmetric and positive definite, else throws ComputationError;
     * @p K of any kind. */
    ShiftedHessenberg(const Eigen::MatrixXd &K, const Eigen::MatrixXd &M);

    /** K + s M of one shift; refers to the object that made it. At an
     * eigenvalue solutions are huge, along its vector. */
    class Factor
    {
    public:
      Eigen::MatrixXcd solve(const Eigen::MatrixXcd &B) const;
      /** With the transposed matrices. */
      Eigen::MatrixXcd solve_transposed(const Eigen::MatrixXcd &B) const;

    private:
      friend class ShiftedHessenberg;
      Factor(const ShiftedHessenberg &owner, const std::complex<double> s);

      const ShiftedHessenberg &owner;
      /** Gaussian elimination with row exchanges. */
      Eigen::Matrix<std::complex<double>,
                    Eigen::Dynamic,
                    Eigen::Dynamic,
                    Eigen::RowMajor>
                        U;
      Eigen::VectorXcd  factors;
      std::vector<bool> exchanged;
    };

    Factor factor(const std::complex<double> s) const;

  private:
    /** M = L L^T, L^-1 K L^-T = Q H Q^T. */
    Eigen::MatrixXd H;
    Eigen::MatrixXd transform; /**< Q^T L^-1 */
  };
} // namespace squeal

#endif
