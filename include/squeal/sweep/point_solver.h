// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_sweep_point_solver_h
#define squeal_sweep_point_solver_h

#include <squeal/eigen/complex_pairs.h>
#include <squeal/sweep/reduced_model.h>

namespace squeal
{
  /** M, C and K (real part, and loss part H) of a reduced model at one
   * parameter point. */
  struct PointMatrices
  {
    Eigen::MatrixXd M, C, K, H;
    bool            rayleigh = false; /**< C = alpha M + beta K, H = 0 */
    double          alpha = 0., beta = 0.;

    /** Of the first @p n vectors. */
    PointMatrices(const LocalModel                    &model,
                  const std::vector<TermCoefficients> &coefficients,
                  const unsigned int                   n);
  };

  /** Of the highest frequency of a band: a growth rate that does not count in
   * suggestions and plots. */
  constexpr double growth_as_good_as_zero = 1e-6;

  /** Which pairs are wanted, Hz. */
  struct Band
  {
    double lowest, highest;
  };

  /**
   * Eigenpairs at one parameter point from a local model, with the error of
   * each against the full one.
   *
   * Vectors are coordinates in V, of mass norm 1. The noise floor is what the
   * rounding of reduced matrices moves the eigenvalue by. The error is the
   * distance to the eigenvalue in all of [V W] that refine_pairs() finds from
   * there. With @p corrected the eigenvalues and vectors (coordinates in
   * [V W]) are the refined ones; the noise floor stays, relative, that of V,
   * as undamped pairs have a sigma of either sign of its size.
   */
  ComplexPairs solve_point(const LocalModel                    &model,
                           const std::vector<TermCoefficients> &coefficients,
                           const Band                          &band,
                           const bool corrected = false);

  /** The same at a point of the box; vectors are coordinates in the common
   * basis. Without @p with_estimates only V is looked at, and the estimates are
   * zero. */
  ComplexPairs solve_point(const ReducedModel                  &model,
                           const Eigen::VectorXd               &point,
                           const std::vector<TermCoefficients> &coefficients,
                           const Band                          &band,
                           const bool with_estimates = true);

  /** From all of the [V W] of the point's cell, without estimates (zero). */
  ComplexPairs solve_point_in_cell(
    const ReducedModel                  &model,
    const Eigen::VectorXd               &point,
    const std::vector<TermCoefficients> &coefficients,
    const Band                          &band);

  /** From V, refined in the whole of the common basis: for what depends on
   * the vectors to first order. */
  ComplexPairs solve_point_refined(
    const ReducedModel                  &model,
    const Eigen::VectorXd               &point,
    const std::vector<TermCoefficients> &coefficients,
    const Band                          &band);

  /** From V alone, without estimates (zero). */
  ComplexPairs solve_point_in_basis(
    const LocalModel                    &model,
    const std::vector<TermCoefficients> &coefficients,
    const Band                          &band);

  /** From all of [V W], without estimates (zero). */
  ComplexPairs solve_point_in_full(
    const LocalModel                    &model,
    const std::vector<TermCoefficients> &coefficients,
    const Band                          &band);

  /** Undamped, frictionless modes of a reduced model up to @p omega_squared,
   * mass-orthonormal coordinates; @p symmetric tells the parts that take part.
   */
  struct ReducedModes
  {
    Eigen::VectorXd omega_squared;
    Eigen::MatrixXd shapes;
  };
  ReducedModes reduced_modes(const std::vector<Eigen::MatrixXd>  &parts,
                             const std::vector<TermCoefficients> &coefficients,
                             const std::vector<bool>             &symmetric,
                             const double omega_squared);

  /** Their number, by the signs of pivots. */
  unsigned int n_modes_below(const std::vector<Eigen::MatrixXd>  &parts,
                             const std::vector<TermCoefficients> &coefficients,
                             const std::vector<bool>             &symmetric,
                             const double omega_squared);
} // namespace squeal

#endif
