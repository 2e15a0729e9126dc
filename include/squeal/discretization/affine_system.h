// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_discretization_affine_system_h
#define squeal_discretization_affine_system_h

#include <squeal/base/linear_operator.h>
#include <squeal/discretization/assembly.h>
#include <squeal/parameters/scene_parameters.h>

#include <complex>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace squeal
{
  /**
   * What one operator part A contributes to the quadratic pencil
   * Q(lambda) = lambda^2 M + lambda C + K: mass A to M, damping A to C,
   * stiffness A to K. A stiffness is complex with structural damping.
   */
  struct TermCoefficients
  {
    double               mass      = 0.;
    double               damping   = 0.;
    std::complex<double> stiffness = 0.;

    bool
    is_zero() const
    {
      return mass == 0. && damping == 0. && stiffness == 0.;
    }
  };

  /**
   * One parameter-independent operator of a scene and the coefficients with
   * which the scene's parameters enter. Sweeps keep the operators and evaluate
   * the coefficients only.
   */
  struct AffineTerm
  {
    std::string                                              name;
    std::shared_ptr<const LinearOperator>                    matrix;
    std::function<TermCoefficients(const SceneParameters &)> coefficients;
    bool is_friction = false; /**< whether its forces are those of friction */
  };

  /**
   * The quadratic pencil of a scene as a sum of affine terms, in the unknowns
   * of a row space. Meshed, lumped and imported scenes all end here.
   */
  struct AffineSystem
  {
    std::shared_ptr<const RowSpace> space;
    std::vector<AffineTerm>         terms;
  };

  /** The terms whose forces are those of friction. */
  AffineSystem friction_terms(const AffineSystem &system);

  /** Stiffness, mass and turning terms of all bodies, springs, dashpots and
   * lumped masses of a scene (everything but contact). */
  AffineSystem body_system(const Discretization            &discretization,
                           const std::vector<BodyMatrices> &bodies);

  /** Inertia that moves with a body: the mass coefficient times the matrix of
   * @p term, in the unknowns of the discretisation. */
  struct BodyInertia
  {
    unsigned int body;
    AffineTerm   term;
  };

  /** The masses of all bodies in their order, then the lumped masses, each of
   * which counts for the body that carries it. Throws InputError for a lumped
   * mass outside its body. */
  std::vector<BodyInertia> inertia_of_bodies(
    const Discretization            &discretization,
    const std::vector<BodyMatrices> &bodies);

  /** alpha of C = alpha M + beta K for a body, 1/s, by the damping model. */
  double mass_damping_of(const SceneParameters &scene, const unsigned int body);

  /** Where point springs are attached, m. */
  std::vector<dealii::Point<3>> spring_points(const SpringParameters &spring);

  /** Coefficients of an elastic part k A with its damping: beta k and
   * (1 + i eta) k by the damping model of the scene. */
  TermCoefficients elastic_coefficients(const SceneParameters &scene,
                                        const double           stiffness,
                                        const double part_stiffness_damping,
                                        const double part_structural_damping);

  /** The same of the stiffness of a body, with its modulus and the loss factor
   * of its modulus table. */
  TermCoefficients elastic_coefficients(const SceneParameters &scene,
                                        const BodyParameters  &body);



  /**
   * The pencil at one set of parameters. Terms whose coefficients are
   * proportional are merged, so that a scene with Rayleigh damping of the whole
   * model has one mass, one symmetric stiffness and one friction operator.
   */
  class Pencil
  {
  public:
    struct Part
    {
      std::shared_ptr<const LinearOperator> matrix;
      TermCoefficients                      coefficients;
      bool                                  symmetric;
    };

    Pencil(const AffineSystem &system, const SceneParameters &parameters);

    /** Keeps every term apart and in order, for affine reduced models. */
    static Pencil unmerged(const AffineSystem    &system,
                           const SceneParameters &parameters);

    const std::vector<Part>        &parts() const;
    std::shared_ptr<const RowSpace> space() const;
    /** True where some stiffness coefficient is complex. */
    bool has_structural_damping() const;
    /**
     * True where C = alpha M + beta K holds for the whole pencil, friction
     * included, and K is real: the eigenvectors are then those of K x =
     * kappa M x.
     */
    bool is_rayleigh_damped(double &alpha, double &beta) const;
    /** True where damping is a force -C u' with a symmetric C: no complex
     * stiffness, and nothing gyroscopic. */
    bool is_viscously_damped() const;

    /** M X, C X and K X (imaginary part of K left out of the real ones). */
    struct Products
    {
      ComplexBlock mass, damping, stiffness;
    };
    Products apply(const ComplexBlock &X) const;
    Products apply_transposed(const ComplexBlock &X) const;

    /** M_0 X, the symmetric part of the mass (the multipliers of an eliminated
     * contact add a non-symmetric one). */
    Block multiply_mass(const Block &X) const;
    /** C_0 X, the symmetric part of the damping. */
    Block multiply_damping(const Block &X) const;
    /** K_0 X, the real symmetric part of the stiffness (no friction). */
    Block multiply_undamped_stiffness(const Block &X) const;

    /** || |K| |x| || for every column: the rounding size of K x over the
     * machine precision. */
    Eigen::VectorXd stiffness_rounding_size(const ComplexBlock &X) const;

    /** Lower triangle of K_0 - shift M_0 of the undamped, frictionless
     * problem. */
    Triplets undamped_entries(const double shift) const;

    /** The symmetric parts with mass, damping and stiffness as one stiffness,
     * mass M + damping C + stiffness K, and nothing else. Real ones only. */
    Pencil combined(const double mass,
                    const double damping,
                    const double stiffness) const;

    /** All entries of Q(lambda). */
    void quadratic_entries(const std::complex<double>         lambda,
                           std::vector<int>                  &rows,
                           std::vector<int>                  &columns,
                           std::vector<std::complex<double>> &values) const;

  private:
    Pencil() = default;
    Products apply(const ComplexBlock &X, const bool transposed) const;
    /** The sum of coefficient A X over the symmetric parts. */
    Block multiply_symmetric(
      const Block &X,
      double (*coefficient)(const TermCoefficients &)) const;

    std::shared_ptr<const RowSpace> row_space;
    std::vector<Part>               all_parts;
  };
} // namespace squeal

#endif
