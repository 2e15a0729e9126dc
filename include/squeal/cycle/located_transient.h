// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_cycle_located_transient_h
#define squeal_cycle_located_transient_h

#include <squeal/cycle/orbit.h>
#include <squeal/transient/reduced_transient.h>

namespace squeal
{
  /**
   * A reduced transient whose changes of status are located within the steps:
   * slip is counted from where a node comes to rest or closes, and the bend
   * that a force has where its node opens, closes, sticks or lets go has its
   * impulse, which a straight line over the step misses. Constant speed and
   * coefficients of friction.
   */
  class LocatedTransient : public ReducedTransient
  {
  public:
    /** References are kept. @p friction: mu >= 0 of every node. */
    LocatedTransient(const ReducedContactModel &model,
                     const double               time_step,
                     TransientDrive             drive,
                     const Eigen::VectorXd     &friction,
                     const double               speed,
                     const double               nodal_force,
                     const double               tolerance);

    /** After start(). */
    void set_past(ContactPast past);
    /** Takes these, which must live on, instead of locating changes. */
    void hold(const StepCorrections &corrections);

    /** Of all steps so far. */
    const StepCorrections &corrections() const;

  private:
    void prepare_step(ContactStep &step) override;
    void finish_step(Eigen::VectorXd &velocity) override;
    /** What the bends of forces in the step add to the velocities. */
    Eigen::VectorXd bends() const;

    const ReducedContactModel &model;
    const Eigen::VectorXd     &friction;
    const double               speed, dt;
    ContactPast                past;
    const StepCorrections     *held = nullptr;
    StepCorrections            used;
    Eigen::VectorXd            force_at_start, motion_at_start; // of the step
  };
} // namespace squeal

#endif
