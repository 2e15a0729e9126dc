// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_transient_reduced_transient_h
#define squeal_transient_reduced_transient_h

#include <squeal/transient/lagged_friction.h>
#include <squeal/transient/modal_step.h>

#include <vector>

namespace squeal
{
  /**
   * Time integration of a reduced contact model. The modes move exactly under
   * forces that change linearly over a step; gap and slip are enforced at its
   * end, the slip as the way over the step. The interface has no mass, so
   * neither impacts nor friction chatter. Throws InputError for a step above
   * largest_stable_step(), which is short where the motions leave the contact
   * little flexibility.
   */
  class ReducedTransient : public TransientIntegrator
  {
  public:
    ReducedTransient(
      const ReducedContactModel  &model,
      const double                time_step,
      TransientDrive              drive,
      const double                nodal_force,
      const double                tolerance = 1e-8,
      const ContactSolver::Method method    = ContactSolver::Method::newton);

    void                   start(const Eigen::VectorXd &q,
                                 const Eigen::VectorXd &velocity,
                                 const Eigen::VectorXd &forces) override;
    ContactReport          advance() override;
    double                 time() const override;
    Eigen::VectorXd        coordinates() const override;
    Eigen::VectorXd        velocities() const override;
    Eigen::VectorXd        observed_motion() const override;
    Eigen::VectorXd        observed_accelerations() const override;
    EnergyLedger           ledger() const override;
    const Eigen::VectorXd &friction_losses() const override;
    unsigned int           n_inversions() const override;
    NamedNumbers           memory() const override;
    void                   restore(const NamedNumbers &memory) override;
    const Eigen::VectorXd &forces() const override;
    const Eigen::VectorXd &motion() const override;
    const std::vector<ContactStatus> &status() const override;

  protected:
    const ModalStep &
    step_of_modes() const
    {
      return modes;
    }
    /** Nodal forces, N, that the contact at the end of the step is solved from:
     * those of the last steps go on. */
    virtual Eigen::VectorXd guess_of_forces() const;

  private:
    /** Called before the contact of a step is solved: may move what slip is
     * counted from. */
    virtual void prepare_step(ContactStep &step);
    /** Called when it has been solved: may change the modes' coordinates and
     * velocities at the end of the step. */
    virtual void finish_step(Eigen::VectorXd &coordinates,
                             Eigen::VectorXd &velocity);

    Eigen::VectorXd external_forces(const double time) const;
    Eigen::VectorXd external_motion(const double time) const;
    void            update_ledger(const Eigen::VectorXd &q_before,
                                  const Eigen::VectorXd &v_before,
                                  const Eigen::VectorXd &lambda_before,
                                  const Eigen::VectorXd &motion_before);
    double          stored_energy() const;
    /** What the residual flexibility stores beside 1/2 lambda G lambda by
     * external forces at @p time that move the nodes by @p motion, J. */
    double energy_of_loads(const double           time,
                           const Eigen::VectorXd &motion,
                           const Eigen::VectorXd &contact_forces) const;
    /** What later steps depend on, beside counts and energies. */
    std::vector<std::pair<std::string, Eigen::VectorXd *>> state();

    const ReducedContactModel &model;
    const double               dt;
    const TransientDrive       drive;
    const ModalStep            modes;
    ContactSolver              solver;
    LaggedFriction             friction;

    unsigned int    n_steps = 0;
    Eigen::VectorXd q, v, u, total_force;
    Eigen::VectorXd lambda, lambda_1, lambda_2; /**< now and before */
    Eigen::VectorXd load_now, motion_now;       /**< by all but the contact */
    EnergyLedger    energies;
    Eigen::VectorXd losses; /**< in slip, of every node, J */
  };
} // namespace squeal

#endif
