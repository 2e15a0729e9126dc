// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_eigen_undamped_modes_h
#define squeal_eigen_undamped_modes_h

#include <squeal/base/mumps.h>
#include <squeal/discretization/affine_system.h>

#include <memory>

namespace squeal
{
  /**
   * (K_0 - shift M_0)^-1 of the undamped, frictionless problem, from one real
   * LDL^T factorisation, and the number of modes below the shift by its
   * inertia.
   */
  class ShiftedInverse
  {
  public:
    /** Factorises, with the factors where @p storage allows. A shift that falls
     * on an eigenvalue is moved by small steps until the factor is regular. */
    ShiftedInverse(const Pencil        &pencil,
                   const double         shift,
                   const FactorStorage &storage = {});

    Block solve(const Block &right_hand_sides) const;
    /** omega^2 of the shift, (rad/s)^2. */
    double shift() const;
    /** Number of modes with omega^2 below the shift. */
    unsigned int n_modes_below() const;
    double       n_factor_entries() const;
    /** Where the factors are, and the bytes that they need in memory. */
    FactorPlace place() const;
    double      needed_memory() const;

  private:
    std::unique_ptr<MumpsFactorization<double>> factor;
    double                                      shift_value;
  };



  /**
   * Undamped, frictionless modes (K_0 - omega^2 M_0) phi = 0, mass-orthonormal,
   * ascending.
   */
  struct UndampedModes
  {
    Eigen::VectorXd omega_squared; /**< (rad/s)^2, may be slightly negative for
                                      rigid motions */
    Block           shapes;        /**< owned rows x modes */
    Eigen::VectorXd residual;      /**< ||K phi - w2 M phi|| / (||K phi|| +
                                      |w2| ||M phi||) */
    /** Modes below the shift, proven complete by the inertia; the first ones.
     */
    unsigned int n_certified = 0;
    /** Further Krylov directions, mass-orthonormal to the shapes: Ritz vectors
     * above the shift that have not converged, but enrich a basis. */
    Block supplement;
    /** Mass times shapes, then mass times supplement. */
    Block mass_products;
    /** K_0 times shapes, then K_0 times supplement. */
    Block stiffness_products;

    double frequency(const unsigned int i) const;

    /** Frees what only the start of a basis needs: supplement and products. */
    void release_start();
  };

  /** Fills in the residuals from the products. */
  void set_residuals(UndampedModes &modes, const RowSpace &space);

  /** How the spectrum is computed. */
  enum class ModeAlgorithm
  {
    block_lanczos, /**< our own, solves with many right-hand sides at once */
    arpack         /**< (P)ARPACK, one right-hand side at a time */
  };

  struct ModeOptions
  {
    /** Error of the eigenvalues 1 / (omega^2 - shift) of the inverse, relative,
     * as the Krylov space bounds it. */
    double        tolerance  = 1e-10;
    ModeAlgorithm algorithm  = ModeAlgorithm::block_lanczos;
    unsigned int  block_size = 8;
    /** Directions the iteration is kept away from (mass-orthonormal): to test
     * that the inertia count notices what is hidden. */
    Block deflated;
  };

  /**
   * All modes below the shift of @p inverse, by shift-invert Lanczos. The
   * number found is compared with the inertia; throws ComputationError when a
   * mode is missing.
   */
  UndampedModes undamped_modes(const Pencil         &pencil,
                               const ShiftedInverse &inverse,
                               const ModeOptions    &options = {});

  /**
   * All modes with omega^2 below @p limit, from a shift in the middle of them:
   * of a wide band, with its modes ever denser, that takes a third of the
   * vectors that a shift at its end does. A second factor counts them. Throws
   * as above.
   */
  UndampedModes undamped_modes(const Pencil      &pencil,
                               const double       limit,
                               const ModeOptions &options = {});
} // namespace squeal

#endif
