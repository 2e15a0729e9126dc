// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_transient_full_transient_h
#define squeal_transient_full_transient_h

#include <squeal/contact/turning_contacts.h>
#include <squeal/transient/lagged_friction.h>
#include <squeal/transient/turning_inertia.h>

#include <memory>

namespace squeal
{
  /**
   * The bodies without contact in all their unknowns, M u'' + C u' + K u = f -
   * B^T lambda with viscous damping, and the contact nodes as in
   * ReducedContactModel. On one rank.
   */
  struct FullContactModel
  {
    std::shared_ptr<const Pencil>         pencil;
    std::shared_ptr<const ReductionBasis> basis; /**< of modal coordinates */
    std::shared_ptr<const Functionals>    relative_motion; /**< B */
    Eigen::VectorXd                       load; /**< f at full load, N */
    Block           observers;   /**< columns l of observed motions l^T u */
    Eigen::VectorXd initial_gap; /**< of every node, m */
    Eigen::VectorXd speed_ratio; /**< as ReducedContactModel::speed_ratio */
    /** Relative motion of the nodes that held supports add, m. */
    Eigen::VectorXd motion_offset;
    /** B in every step where meshes of targets turn, their unknowns being
     * displacements in axes that turn with them; null: B stays. */
    std::shared_ptr<TurningContacts> turning = {};
    /** Inertia of what turns; null: none. */
    std::shared_ptr<const TurningInertia> inertia = {};

    unsigned int
    n_nodes() const
    {
      return initial_gap.size();
    }
  };

  /** The motion of all unknowns for each column of modes @p q, with the static
   * residual deformation under the nodal forces of the same column of @p
   * forces (loads and contact, N). Factorises once. */
  Block static_motions(const FullContactModel &model,
                       const Eigen::MatrixXd  &q,
                       const Block            &forces);

  /** The motion of modes @p q under @p share of the load and the contact forces
   * @p lambda. Factorises. */
  Eigen::VectorXd static_motion(const FullContactModel &model,
                                const Eigen::VectorXd  &q,
                                const double            share,
                                const Eigen::VectorXd  &lambda);

  /** What the integrators of a full model have in common. */
  class FullTransient : public TransientIntegrator
  {
  public:
    void                   start(const Eigen::VectorXd &q,
                                 const Eigen::VectorXd &velocity,
                                 const Eigen::VectorXd &forces) override;
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
    const Eigen::VectorXd *unknowns() const override;
    const std::vector<ContactStatus> &status() const override;

  protected:
    FullTransient(FullContactModel model,
                  const double     time_step,
                  TransientDrive   drive);

    /** The solver of a step's contact with delassus(), m/N, symmetric but for
     * rounding. */
    void set_contact(const double                nodal_force,
                     const double                tolerance,
                     const ContactSolver::Method method);

    /** Sets what follows from positions, velocities and accelerations at the
     * start. */
    virtual void initialize() = 0;
    /** Vectors that later steps depend on, beside those of this class. */
    virtual std::vector<std::pair<std::string, Eigen::VectorXd *>> further_state() = 0;

    Eigen::VectorXd external_force(const double time) const;
    /** Coriolis and centrifugal forces on the motion from the start, N; empty
     * where nothing turns. */
    Eigen::VectorXd inertial_force(const double time) const;
    Eigen::VectorXd relative(const Eigen::VectorXd &x) const;
    /** f - B^T lambda. */
    Eigen::VectorXd applied(const double           time,
                            const Eigen::VectorXd &contact_forces) const;
    Eigen::VectorXd mass_times(const Eigen::VectorXd &x) const;
    Eigen::VectorXd stiffness_times(const Eigen::VectorXd &x) const;
    /** C x where damping has a matrix of its own; empty elsewhere. */
    Eigen::VectorXd damping_matrix_times(const Eigen::VectorXd &x) const;
    ContactStep     contact_step(const double end) const;
    Eigen::VectorXd extrapolated_forces() const;
    /** Keeps the forces of a step and ends it at position @p next. */
    void finish_step(const ContactStep     &step,
                     const Eigen::VectorXd &next,
                     const Eigen::VectorXd &contact_forces);
    /** Turns the target to the end of @p step. */
    void turn(const ContactStep &step);
    /** The operator of the solver for B as it is, m/N. */
    virtual Eigen::MatrixXd delassus() = 0;
    /** Enters the work of @p contact_forces over a motion of the nodes. What
     * the turning alone has moved them in the step is work of the target that
     * turns, whatever the direction. */
    void enter_contact_work(const ContactStep     &step,
                            const Eigen::VectorXd &contact_forces,
                            const Eigen::VectorXd &motion_of_nodes);

    const FullContactModel model;
    const double           dt;
    const TransientDrive   drive;
    /** C = alpha M + beta K, or a matrix of its own where it is not; alpha and
     * beta are zero then. */
    double                         alpha = 0., beta = 0.;
    bool                           has_damping_matrix = false;
    std::unique_ptr<ContactSolver> solver;
    LaggedFriction                 friction;
    Eigen::VectorXd                u_start; /**< of the unknowns, m */

    unsigned int    n_steps = 0;
    Eigen::VectorXd u, v, a;                    /**< of the unknowns */
    Eigen::VectorXd lambda, lambda_1, lambda_2; /**< now and before, N */
    Eigen::VectorXd nodes_motion;               /**< B u + motion_offset, m */
    EnergyLedger    energies;
    Eigen::VectorXd losses; /**< in slip, of every node, J */

    std::shared_ptr<const Functionals> B; /**< at the end of the last step */
    /** Speed of the drive over time so far, m; empty where no mesh turns. */
    Eigen::VectorXd way;
    Eigen::VectorXd carried; /**< what the turning alone moves the nodes in the
                                  step at hand, m */

  private:
    void                                                   set_turn();
    Eigen::MatrixXd                                        symmetric_delassus();
    std::vector<std::pair<std::string, Eigen::VectorXd *>> state();
  };
} // namespace squeal

#endif
