// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_transient_reduction_basis_h
#define squeal_transient_reduction_basis_h

#include <squeal/base/low_rank_matrix.h>
#include <squeal/discretization/affine_system.h>
#include <squeal/eigen/undamped_modes.h>

#include <functional>

namespace squeal
{
  /**
   * The motions of the bodies without contact that carry mass in a reduced
   * model, orthonormal in the mass and orthogonal in the stiffness: all modes
   * below a cut-off, and Ritz vectors of the contact's own flexibility.
   *
   * The Ritz vectors come from the block Krylov space {R, A R}, R = A B^T the
   * responses to the contact forces without their share in the modes and
   * A v = (1 - phi phi^T M) K^-1 M v: the part of the modes above the cut-off
   * that the contact excites, with few vectors.
   */
  struct ReductionBasis
  {
    Block           shapes, mass_shapes;
    Eigen::VectorXd omega_squared; /**< (rad/s)^2; 0 for rigid motions */
    unsigned int    n_modes;       /**< the first ones, Ritz vectors follow */
  };

  /** Ritz vectors up to @p interface_cut_off, Hz; none where it is 0.
   * @p relative_motion: B of all contact nodes. */
  ReductionBasis reduction_basis(const Pencil        &pencil,
                                 const UndampedModes &modes,
                                 const Functionals   &relative_motion,
                                 const double         interface_cut_off = 0.);

  /** What forces on functionals B move there by the motions that a basis leaves
   * out, quasi-statically, and to the next order: with x = A B^T,
   * B u = (flexibility - lambda damping - lambda^2 inertia) f
   *       + (participation - lambda coupling) q
   * for e^(lambda t) and the coordinates q of the basis, which feel f by the
   * transpose of that participation.
   */
  struct ResidualFlexibility
  {
    Eigen::MatrixXd flexibility; /**< B A B^T, m/N, symmetric */
    Eigen::MatrixXd inertia;     /**< x^T M x, m s^2/N */
    Eigen::MatrixXd damping;     /**< x^T C x, m s/N */
    /** x^T C phi of the whole basis; empty where the damping is that of the
     * whole model by its mass and stiffness, which leaves it zero. */
    Eigen::MatrixXd coupling;
  };

  /** Shift of the factor of static responses, Hz. */
  constexpr double residual_shift = 20.;

  /** Static responses to forces without their share in a basis, on a factor
   * just below zero, where rigid motions do no harm. */
  class ResidualResponse
  {
  public:
    /** References are kept. Factorises at -(2 pi @p shift)^2, @p shift in Hz. */
    ResidualResponse(const Pencil         &pencil,
                     const ReductionBasis &basis,
                     const double          shift = residual_shift);
    Block operator()(const Block &forces) const;

    /** The same but for an error of (shift / f)^2 in modes of the frequency f,
     * with half of the work. */
    Block approximate(const Block &forces) const;

    /** What forces on @p functionals move there, A being the operator above. A
     * solve a column, where the operator takes two. */
    ResidualFlexibility flexibility(const Functionals &functionals) const;

  private:
    /** Without the share of the modes. */
    Block without_modes(const Block &forces) const;
    void  subtract_ritz_vectors(const Block &forces, Block &x) const;
    /** x^T C phi. */
    Eigen::MatrixXd damping_of_basis(const Block &x) const;
    /** x^T A x of a symmetric operator. */
    Eigen::MatrixXd products(
      const Block                               &x,
      const std::function<Block(const Block &)> &multiply) const;

    const RowSpace       &space;
    const ReductionBasis &basis;
    const Pencil         &pencil;
    const ShiftedInverse  inverse;
  };
} // namespace squeal

#endif
