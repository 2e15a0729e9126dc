// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_transient_implicit_transient_h
#define squeal_transient_implicit_transient_h

#include <squeal/transient/contact_compliance.h>
#include <squeal/transient/full_transient.h>

namespace squeal
{
  /**
   * Trapezoidal rule with contact conditions on velocities at the end of a
   * step (Moreau and Jean's scheme with theta = 1/2, no restitution): with v_h
   * the mean velocity of the step,
   *   A v_h = M v_0 + dt/2 (f_h - K u_0 - B^T lambda),
   *   A = M + dt/2 C + dt^2/4 K, u_1 = u_0 + dt v_h, v_1 = 2 v_h - v_0.
   * Nodes that were closed, or that would touch within half a step, obey
   * 0 <= lambda_n complementary to -(B_n v_1) >= 0, and Coulomb's law with the
   * slip rate of v_1. A is factorised once.
   *
   * Where the target turns B is that of the end of the step, and what the
   * turning alone moves the nodes in a step adds to dt B v_1.
   *
   * Multiplied by v_h the scheme is an exact balance of energy; what it loses
   * at impacts is lambda_n (B_n v_h) dt.
   */
  class ImplicitTransient : public FullTransient
  {
  public:
    ImplicitTransient(
      FullContactModel            model,
      const double                time_step,
      TransientDrive              drive,
      const double                nodal_force,
      const double                tolerance = 1e-8,
      const ContactSolver::Method method    = ContactSolver::Method::newton);

    ContactReport advance() override;

  protected:
    void initialize() override;
    std::vector<std::pair<std::string, Eigen::VectorXd *>> further_state()
      override;
    Eigen::MatrixXd delassus() override;

  private:
    /** Motion of the nodes in a step without contact forces, as the solver
     * takes it: normal parts are -gap rates. */
    Eigen::VectorXd free_motion(const Eigen::VectorXd &right_hand_side) const;
    void            set_stored_energy();

    const double                       stiffness_factor; /**< of K in A */
    std::unique_ptr<ShiftedInverse>    inverse;   /**< stiffness_factor A^-1 */
    Block                              responses; /**< A^-1 B^T where B stays */
    std::unique_ptr<ContactCompliance> compliance; /**< where it turns; of
                                                        `inverse` */
    Eigen::VectorXd K_u, M_v;
    Eigen::VectorXd touching; /**< 1 for closed nodes */
    Eigen::VectorXd inertial; /**< forces of turning a step ago, N */
  };
} // namespace squeal

#endif
