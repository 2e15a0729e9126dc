// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_transient_explicit_transient_h
#define squeal_transient_explicit_transient_h

#include <squeal/base/symmetric_block_matrix.h>
#include <squeal/transient/full_transient.h>

namespace squeal
{
  /** The largest circular frequency of a model with the diagonal mass @p mass,
   * rad/s, by Lanczos iterations on M^-1 K; the residual is added, so that it
   * errs on the high side. */
  double largest_frequency(const Pencil &pencil, const Eigen::VectorXd &mass);

  /** The largest stable step of the beta-2 scheme, s: gamma h^2 omega^2 + h
   * (alpha + beta omega^2) <= 2 with gamma = @p beta_2, from the
   * amplification matrix of a mode with lagged damping. */
  double critical_step(const double omega,
                       const double alpha,
                       const double beta,
                       const double beta_2);

  /**
   * Beta-2 scheme with forward-increment Lagrange multipliers (Carpenter,
   * Taylor, Katona 1991) and diagonal mass: with the lagged velocity w_n =
   * u'_(n-1) + (1 - beta_2) dt u''_(n-1),
   *   M u''_n = f_n - C w_n - K u_n - B^T lambda,
   *   u_(n+1) = u_n + dt w_n + (beta_2 + 1/2) dt^2 u''_n,
   *   w_(n+1) = w_n + dt u''_n,
   * lambda such that gap and slip increment at t_(n+1) obey the law of contact.
   * beta_2 = 1/2 is central differences; K w_(n+1) is then (K u_(n+1) - K u_n)
   * / dt, and a step costs one product with K.
   *
   * Energies: kinetic w_n M w_n / 2, elastic u_(n-1) K u_n / 2, work over (w_n
   * + w_(n+1)) dt / 2: an identity of the scheme.
   */
  class ExplicitTransient : public FullTransient
  {
  public:
    /** Throws InputError where the mass is not diagonal or the step is larger
     * than critical. */
    ExplicitTransient(
      FullContactModel            model,
      const double                time_step,
      TransientDrive              drive,
      const double                nodal_force,
      const double                tolerance = 1e-8,
      const ContactSolver::Method method    = ContactSolver::Method::newton,
      const double                beta_2    = 0.5);

    ContactReport advance() override;
    double        largest_step() const; /**< stable, s */

  protected:
    void initialize() override;
    std::vector<std::pair<std::string, Eigen::VectorXd *>> further_state()
      override;
    Eigen::MatrixXd delassus() override;

  private:
    /** K u and K w of this step. */
    void multiply_by_stiffness();

    const double         beta_2;
    Eigen::VectorXd      mass;
    double               stable_step;
    SymmetricBlockMatrix stiffness;
    Eigen::VectorXd      w; /**< lagged velocity */
    Eigen::VectorXd      K_u, K_w;
    Eigen::VectorXd      predicted; /**< u_(n+1) without contact */
  };
} // namespace squeal

#endif
