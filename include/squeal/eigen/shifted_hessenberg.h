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
   * takes n^2. The inverse is reduced, not K: directions of a stiff contact,
   * many orders above the band, are small there and drown nothing.
   */
  class ShiftedHessenberg
  {
  public:
    /** @p M symmetric and positive definite, else throws ComputationError;
     * @p K of any kind. Of a K with free motions @p highest, a circular
     * frequency of the size of those of the shifts, rad/s, tells them from the
     * rest, which their rounding would drown. */
    ShiftedHessenberg(const Eigen::MatrixXd &K,
                      const Eigen::MatrixXd &M,
                      const double           highest = 0.);

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
    /** With D the scales of the unknowns and A = D (K + kappa_0 M) D:
     * A^-1 D M D = Q H Q^T, and K + s M = D^-1 A Q (1 + (s - kappa_0) H) Q^T
     * D^-1. */
    double          kappa_0 = 0.;
    Eigen::MatrixXd H;
    Eigen::MatrixXd before; /**< Q^T A^-1 D */
    Eigen::MatrixXd after;  /**< D Q */
  };
} // namespace squeal

#endif
