// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_discretization_pair_error_h
#define squeal_discretization_pair_error_h

#include <squeal/discretization/eigenvalue_error.h>

#include <Eigen/Sparse>

#include <complex>
#include <vector>

namespace squeal
{
  /** Complex pairs of a damped scene with friction: Q(lambda) x = 0 and
   * y^T Q(lambda) = 0, vectors in all rows of the discretisation. */
  struct PairShapes
  {
    Eigen::VectorXcd lambda;      /**< 1/s */
    ComplexBlock     right, left; /**< x and y, owned rows */
    Eigen::VectorXcd derivative;  /**< y^T (2 lambda M + C) x */
  };

  /** The columns in which the vectors of pairs are worked on: real and
   * imaginary part of x, then of y, pair after pair. */
  Block columns_of(const PairShapes &pairs);

  /** Estimated errors of complex eigenvalues by the mesh. */
  struct PairErrors
  {
    /** lambda - lambda_h, 1/s: the real part is that of the growth rate. Of
     * all pairs together: see estimate_pair_errors(). */
    Eigen::VectorXcd lambda;
    /** What the mesh gives to each pair alone, to first order, 1/s. */
    Eigen::VectorXcd first_order;
    /** The part of it that arises in cells with pointwise forces and is left
     * out of `lambda`, as in ModeErrors. */
    Eigen::VectorXcd at_points;
    /** One row a pair, one column an active cell: what the cell gives to
     * `first_order`, 1/s; zero on cells of other ranks. */
    Eigen::MatrixXcd cell;
  };

  /**
   * Estimates how far the mesh shifts every complex eigenvalue and where, by
   * the dual weighted residual (Heuveline and Rannacher, J. Numer. Math. 9,
   * 2001) in the enrichment spaces of estimate_mode_errors(): with the
   * residuals r_x and r_y of both vectors against the functions b of a cell
   * that the mesh does not have,
   *
   *   E_ij = sum over cells r_yi^T Q_bb^-1 r_xj / (y_i^T (2 lambda_i M + C)
   * x_i)
   *
   * is what the mesh adds to the eigenvalues in the space of the pairs, where
   * Q_bb is the stiffness with its damping (1 + lambda beta + i eta) of the
   * body; its inertia is of higher order. Times (p + 1)/2, as there. A pair
   * alone shifts by E_ii, its first order, and undamped modes without friction
   * by the estimate of those. Two pairs that lock in do not: their growth rate
   * hangs on the difference of what the mesh does to their partners, through
   * E_12 E_21. The errors are therefore those of the eigenvalues of
   * diag(lambda) + E among all pairs, followed from those of diag(lambda):
   * the more neighbours of a pair are given, the better.
   *
   * Gyroscopic terms of turning bodies and the damping of slip rates are left
   * out.
   *
   * @param forces on both vectors of every pair, in columns as columns_of(); of
   * the left vector those of the transposed problem, all over the damping
   * factor of the body.
   */
  PairErrors estimate_pair_errors(const Discretization &discretization,
                                  const PairShapes     &pairs,
                                  const std::vector<PointForces> &forces);

  /** 1 + lambda beta + i eta of a body: what its stiffness is multiplied by. */
  std::complex<double> stiffness_factor(const SceneParameters     &scene,
                                        const unsigned int         body,
                                        const std::complex<double> lambda);

  /** What turns columns_of() into their inertia forces over the density: W of
   * CellErrorProblem for a body. */
  Eigen::SparseMatrix<double> inertia_of_columns(
    const SceneParameters  &scene,
    const unsigned int      body,
    const Eigen::VectorXcd &lambda);

  /** -(lambda^2 + alpha lambda) over stiffness_factor(): omega^2 of an undamped
   * mode. */
  std::complex<double> inertia_factor(const SceneParameters     &scene,
                                      const unsigned int         body,
                                      const std::complex<double> lambda);
} // namespace squeal

#endif
