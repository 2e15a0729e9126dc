// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_transient_transient_integrator_h
#define squeal_transient_transient_integrator_h

#include <squeal/contact/friction_law.h>
#include <squeal/transient/contact_solver.h>
#include <squeal/transient/reduced_contact_model.h>

#include <functional>
#include <memory>
#include <vector>

namespace squeal
{
  /** What drives a transient; every function is one of time, s. */
  struct TransientDrive
  {
    using Function = std::function<double(double)>;
    Function friction; /**< mu; with laws what is added to their mu in pairs
                          that slide. A sum below 0 counts as 0 */
    /** Speed, m/s, that those of the nodes are measured by; negative: turning
     * back. */
    Function speed;
    Function load; /**< share of the full load of the model */

    /** A further force with its course in time: a load with a ramp of its
     * own, a blow. */
    struct Force
    {
      ModalForce force;
      Function   factor;
    };
    std::vector<Force> forces;
    /** f_i R f_j of the load of the model and of these forces, in this order,
     * on the residual flexibility R of the bodies, N m: what they do work on
     * where they act. Empty: nothing. */
    Eigen::MatrixXd flexibility;
    /** mu of every node over its slip rate; null: one mu for all, which depends
     * on time alone. */
    std::shared_ptr<const FrictionLaws> laws = {};
  };

  /** Energies since the start, J. */
  struct EnergyLedger
  {
    double kinetic = 0., elastic = 0.;
    double damping  = 0.;  /**< lost in the bodies' viscous damping */
    double friction = 0.;  /**< lost in slip */
    double driving  = 0.;  /**< work of the sliding target on the bodies, also
                              by what its turning mesh carries past the source
                            */
    double load      = 0.; /**< work of the loads */
    double numerical = 0.; /**< lost by the scheme, from its own identity:
                              nodal forces that open or close a gap within a
                              step, and beta_2 above 1/2 */

    /** Its members by name, for checkpoints. */
    NamedNumbers memory() const;
    void         restore(const NamedNumbers &memory);

    /** What does not add up, relative to the work done. */
    double imbalance() const;
    double start = 0.; /**< kinetic + elastic at the start */
  };

  /**
   * A motion in time with contact, step by step. Three contact unknowns a
   * node: normal, along and across the sliding, interleaved.
   */
  class TransientIntegrator
  {
  public:
    virtual ~TransientIntegrator() = default;

    /** Sets time 0: positions and velocities of the modes, and contact forces
     * whose residual deformation is there as well. */
    virtual void start(const Eigen::VectorXd &q,
                       const Eigen::VectorXd &velocity,
                       const Eigen::VectorXd &forces) = 0;

    /** One step. Throws ComputationError. */
    virtual ContactReport advance() = 0;

    virtual double time() const = 0;
    /** The motion in the modes of the reduced model. */
    virtual Eigen::VectorXd                   coordinates() const = 0;
    virtual Eigen::VectorXd                   velocities() const  = 0;
    virtual const Eigen::VectorXd            &forces() const      = 0; /**< N */
    virtual const Eigen::VectorXd            &motion() const      = 0; /**< m */
    virtual const std::vector<ContactStatus> &status() const      = 0;
    /** The motion of all unknowns of the finite elements, m; null where only
     * modes move. */
    virtual const Eigen::VectorXd *
    unknowns() const
    {
      return nullptr;
    }
    /** Motions and accelerations of the observers. */
    virtual Eigen::VectorXd observed_motion() const        = 0;
    virtual Eigen::VectorXd observed_accelerations() const = 0;
    virtual EnergyLedger    ledger() const                 = 0;
    /** EnergyLedger::friction of every node, J. */
    virtual const Eigen::VectorXd &friction_losses() const = 0;
    virtual unsigned int n_inversions() const = 0; /**< see ContactSolver */

    /** @name All that later steps depend on: the same bits after restore() */
    //@{
    virtual NamedNumbers memory() const = 0;
    /** After start(). Throws InputError where sizes are not those of this
     * motion. */
    virtual void restore(const NamedNumbers &) = 0;
    //@}
  };
} // namespace squeal

#endif
