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
    /** lambda - lambda_h, 1/s: the real part is that of the growth rate. */
    Eigen::VectorXcd lambda;
    /** The part of it that arises in cells with pointwise forces and is left
     * out of `lambda`, as in ModeErrors. */
    Eigen::VectorXcd at_points;
    /** One row a pair, one column an active cell: what the cell gives to
     * `lambda`, 1/s; zero on cells of other ranks. */
    Eigen::MatrixXcd cell;

    /** Of @p n pairs whose errors are not known: NaN, real and imaginary
     * parts alike. */
    static PairErrors unknown(const Eigen::Index n);
  };

  /**
   * Estimates how far the mesh shifts every complex eigenvalue and where, by
   * the dual weighted residual (Heuveline and Rannacher, J. Numer. Math. 9,
   * 2001) in the enrichment spaces of estimate_mode_errors(): with the
   * residuals r_x and r_y of both vectors against the functions b of a cell
   * that the mesh does not have,
   *
   *   lambda - lambda_h = sum over cells r_y^T Q_bb^-1 r_x
   *                       / (y^T (2 lambda M + C) x),
   *
   * where Q_bb is the stiffness with its damping (1 + lambda beta + i eta) of
   * the body; its inertia is of higher order. Times (p + 1)/2, as there. For
   * undamped modes without friction it is the estimate of those.
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
