// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_transient_reduced_transient_h
#define squeal_transient_reduced_transient_h

#include <squeal/transient/contact_solver.h>
#include <squeal/transient/reduced_contact_model.h>

#include <functional>
#include <vector>

namespace squeal
{
  /** What drives a transient; every function is one of time, s. */
  struct TransientDrive
  {
    using Function = std::function<double(double)>;
    Function friction; /**< mu >= 0 */
    Function speed;    /**< |V| at the centre, m/s; negative: turning back */
    Function load;     /**< share of the full load */

    /** A further force with its course in time. */
    struct Force
    {
      ModalForce force;
      Function   factor;
    };
    std::vector<Force> forces;
  };

  /** Energies since the start, J. */
  struct EnergyLedger
  {
    double kinetic = 0., elastic = 0.;
    double damping   = 0.; /**< lost in the bodies' viscous damping */
    double friction  = 0.; /**< lost in slip */
    double driving   = 0.; /**< work of the sliding target on the bodies */
    double load      = 0.; /**< work of the loads */
    double numerical = 0.; /**< lost by the scheme at the contact: nodal forces
                              that open or close a gap within a step */

    /** What does not add up, relative to the work done. */
    double imbalance() const;
    double start = 0.; /**< kinetic + elastic at the start */
  };

  /**
   * Time integration of a reduced contact model. The modes move exactly under
   * forces that change linearly over a step; gap and slip are enforced at its
   * end, the slip as the way over the step. The interface has no mass, so
   * neither impacts nor friction chatter.
   */
  class ReducedTransient
  {
  public:
    ReducedTransient(const ReducedContactModel &model,
                     const double               time_step,
                     TransientDrive             drive,
                     const double               nodal_force,
                     const double               tolerance = 1e-8);

    /** Sets time 0, positions, velocities and contact forces. */
    void start(const Eigen::VectorXd &q,
               const Eigen::VectorXd &velocity,
               const Eigen::VectorXd &forces);

    /** One step. Throws ComputationError. */
    ContactReport advance();

    double                            time() const;
    const Eigen::VectorXd            &coordinates() const;
    const Eigen::VectorXd            &velocities() const;
    const Eigen::VectorXd            &forces() const; /**< lambda, N */
    const Eigen::VectorXd            &motion() const; /**< B u, m */
    const std::vector<ContactStatus> &status() const;
    /** Damped, driven: q''. */
    Eigen::VectorXd accelerations() const;
    EnergyLedger    ledger() const;
    unsigned int    n_inversions() const; /**< see ContactSolver */
    /** Share of the full load now. */
    double load_share() const;

    /** @name All that later steps depend on: the same bits after restore() */
    //@{
    std::vector<double> memory() const;
    void                restore(const std::vector<double> &memory);
    //@}

  private:
    Eigen::VectorXd external_forces(const double time) const;
    Eigen::VectorXd external_motion(const double time) const;
    void            update_ledger(const Eigen::VectorXd &q_before,
                                  const Eigen::VectorXd &v_before,
                                  const Eigen::VectorXd &lambda_before,
                                  const Eigen::VectorXd &motion_before);
    double          stored_energy() const;

    const ReducedContactModel &model;
    const double               dt;
    const TransientDrive       drive;
    /** q_1 = q_q q_0 + q_v v_0 + q_0 F_0 + q_1 F_1, and so for v_1. */
    Eigen::VectorXd q_q, q_v, q_f0, q_f1, v_q, v_v, v_f0, v_f1;
    ContactSolver   solver;

    unsigned int    n_steps = 0;
    Eigen::VectorXd q, v, u, total_force;
    Eigen::VectorXd lambda, lambda_1, lambda_2; /**< now and before */
    Eigen::VectorXd load_now, motion_now;       /**< by all but the contact */
    EnergyLedger    energies;
  };
} // namespace squeal

#endif
