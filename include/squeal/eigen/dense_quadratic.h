// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_eigen_dense_quadratic_h
#define squeal_eigen_dense_quadratic_h

#include <squeal/discretization/affine_system.h>

#include <Eigen/Core>

#include <vector>

namespace squeal
{
  /** One operator part of a reduced pencil and its coefficients. */
  struct ReducedPart
  {
    Eigen::MatrixXd  matrix;
    TermCoefficients coefficients;
  };

  /**
   * Eigenpairs of a small quadratic pencil: Q(lambda) x = 0 and y^T Q(lambda) =
   * 0 (no conjugation), one of each conjugate pair (Im lambda > 0) and every
   * real eigenvalue.
   */
  struct DensePairs
  {
    Eigen::VectorXcd lambda;
    Eigen::MatrixXcd right, left;
  };

  /**
   * Solves by LAPACK. With C = alpha M + beta K throughout (@p rayleigh) the
   * problem is K x = kappa M x of the single size, and lambda follows from
   * lambda^2 + lambda (alpha + beta kappa) + kappa = 0; otherwise a companion
   * form of twice the size is used.
   */
  DensePairs solve_dense_quadratic(const std::vector<ReducedPart> &parts,
                                   const bool                      rayleigh,
                                   const double                    alpha,
                                   const double                    beta);

  /** Size of eigenvalues over the highest circular frequency of a band below
   * which they are not told from rigid motions, whose zeros rounding moves to
   * either side. */
  constexpr double share_of_rigid_motions = 1e-4;

  /** Of @p lambda below the circular frequency @p lowest the one that grows
   * fastest, 0 where none does that is told from rigid motions. */
  std::complex<double> fastest_growth_below(const Eigen::VectorXcd &lambda,
                                            const double            lowest,
                                            const double            highest);

  /** Whether the frequency @p f, Hz, is one of the band from @p lowest to @p
   * highest, whose ends belong to it: what differs from one by rounding, 1e-9
   * of it, is there. */
  bool is_between(const double f, const double lowest, const double highest);

  /** Whether @p lambda, 1/s, is one of the band from @p lowest to @p highest,
   * Hz: by its frequency and, where it decays, by |lambda| <= 4 pi highest.
   * Overdamped motions far beyond pass through any band as a basis grows; no
   * mesh resolves them. What grows counts however fast: up to 1e4 times the
   * highest circular frequency, beyond which rounding makes growth of the
   * infinite eigenvalues of directions without mass. */
  bool is_of_band(const std::complex<double> lambda,
                  const double               lowest,
                  const double               highest);

  /** Whether @p lambda, 1/s, grows and has |lambda| > 4 pi highest, with
   * @p highest in Hz: not every basis resolves it. */
  bool grows_beyond_band(const std::complex<double> lambda,
                         const double               highest);

  /** How many eigenvalues of lambda^2 M + lambda C + K have Im lambda above
   * @p omega > 0. */
  Eigen::Index n_eigenvalues_above(const Eigen::MatrixXd  &M,
                                   const Eigen::MatrixXd  &C,
                                   const Eigen::MatrixXcd &K,
                                   const double            omega);
} // namespace squeal

#endif
