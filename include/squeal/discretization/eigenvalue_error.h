// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_discretization_eigenvalue_error_h
#define squeal_discretization_eigenvalue_error_h

#include <squeal/discretization/discretization.h>

#include <Eigen/Core>

#include <vector>

namespace squeal
{
  /**
   * Forces that act on a body while it vibrates in a mode and that its
   * elasticity and inertia do not know: springs, contact, mortar ties, point
   * masses. Without them the estimate takes the place for a free surface and
   * comes out too large.
   */
  struct PointForces
  {
    unsigned int                  body = 0;
    std::vector<dealii::Point<3>> points; /**< m, the same on every rank */
    /** (3 n_points) x n_modes, N for the modes as they are scaled: x, y, z on
     * the first point, then on the second. The same on every rank. */
    Eigen::MatrixXd forces;
    /** Distance of neighbouring points, m: 0 for the quadrature points of an
     * area, infinity for a lone point. */
    double spacing = 0.;
  };

  /** Estimated discretisation errors of modes. */
  struct ModeErrors
  {
    /** (f_h - f) / f of every mode; 0 of rigid-body modes. */
    Eigen::VectorXd frequency;
    /** The part of `frequency` that arises in cells with pointwise forces and
     * is left out there: see estimate_mode_errors(). */
    Eigen::VectorXd at_points;
    /** What to refine by, one number an active cell, zero on cells of other
     * ranks: the contributions of the cell to `frequency`, each mode weighted
     * by its error over the largest one. */
    std::vector<double> cell;
  };

  /**
   * Estimates the discretisation error of the frequency of every mode and
   * where it arises, without another solution.
   *
   * The error of omega^2 is the elastic energy of the error of the mode
   * (normed to u^T M u = 1) but for terms of higher order. In every cell K the
   * error e is sought among the polynomials of degree p + 1 that vanish at the
   * nodes of degree p, driven by what the mode leaves over (Bank and Weiser,
   * Math. Comp. 44, 1985):
   *
   *   a_K(e, v) = omega^2 (rho u, v)_K - a_K(u, v) + (t, v)_dK + forces,
   *
   * where t on inner faces is the traction both cells can agree on, the mean
   * weighted by their stiffness, and zero on free faces. The energy a_K(e, e)
   * is what one degree more would gain. It is multiplied by (p + 1)/2: along
   * an edge where the solution goes like r^a the energy of the error falls
   * like p^(-4a), so that one degree more gains only the part 4a/(p + 1) of
   * it (a = 0.71 at a clamped edge with a right angle). Smooth modes are
   * overestimated by up to that factor.
   *
   * A force at a point has no convergent displacement in three dimensions: in
   * cells that hold pointwise forces, that is whose edges are shorter than
   * p times the spacing, the error belongs to the model (the spring acts
   * through the cell that carries it). It is reported in `at_points` and
   * drives no refinement.
   *
   * @param modes owned rows, u^T M u = 1 with the mass of the whole model
   * @param omega_squared 1/s^2, one a mode; values below 1e-9 of the largest
   * count as rigid-body modes
   */
  ModeErrors estimate_mode_errors(const Discretization  &discretization,
                                  const Block           &modes,
                                  const Eigen::VectorXd &omega_squared,
                                  const std::vector<PointForces> &forces = {});
} // namespace squeal

#endif
