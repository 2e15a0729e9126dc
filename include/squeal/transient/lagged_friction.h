// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_transient_lagged_friction_h
#define squeal_transient_lagged_friction_h

#include <squeal/transient/transient_integrator.h>

namespace squeal
{
  /**
   * Gives every step the coefficients of friction of a drive. Where they fall
   * with the slip rate, a node that slipped in the last step, or was open, has
   * the one at its slip rate then, and one that stuck has the one at rest:
   * within a step Coulomb's law has fixed coefficients. A node that slips
   * sticks again where the coefficient at its last slip rate can hold it, so
   * that the static one takes hold of nothing that moves. Where they rise about
   * that slip rate they are those of the slip rate of the step itself, as far
   * as they nowhere fall. First order in the step.
   */
  class LaggedFriction
  {
  public:
    /** A copy of the drive's functions is kept. @p speed_ratio: of every node
     * over the speed of the drive. */
    LaggedFriction(const TransientDrive  &drive,
                   const Eigen::VectorXd &speed_ratio);

    /** Nodes with the relative velocities @p rate of the bodies, three a node,
     * m/s, at time 0. */
    void start(const Eigen::VectorXd &rate);
    /** Sets the coefficients of @p step, which ends at @p time. */
    void set(const double time, ContactStep &step) const;
    /** Keeps the slip rates of @p step, which has been solved. */
    void keep(const ContactStep                &step,
              const Eigen::VectorXd            &motion,
              const std::vector<ContactStatus> &status);

    /** What later steps depend on: what each node remembers, see FrictionLaw;
     * empty where all coefficients are constant. */
    Eigen::VectorXd       &state();
    const Eigen::VectorXd &state() const;

  private:
    TransientDrive::Function            added;
    TransientDrive::Function            speed;
    std::shared_ptr<const FrictionLaws> laws;
    bool            by_slip_rate; /**< whether some law depends on it */
    bool            rises;        /**< whether some law rises with it */
    Eigen::VectorXd ratio, memory;
  };
} // namespace squeal

#endif
