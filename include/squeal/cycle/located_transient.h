// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_cycle_located_transient_h
#define squeal_cycle_located_transient_h

#include <squeal/cycle/slip_origin.h>
#include <squeal/transient/reduced_transient.h>

namespace squeal
{
  /**
   * A reduced transient whose changes of status are located within the steps:
   * slip is counted from where a node comes to rest or closes, and the bend
   * that a force has where its node opens, closes, sticks or lets go has its
   * impulse, which a straight line over the step misses. Where a node sticks by
   * a larger coefficient than it slips by, its force jumps when it lets go: its
   * limit in that step is that of slip. Constant speed.
   */
  class LocatedTransient : public ReducedTransient
  {
  public:
    /** References are kept. Coefficients are those of @p friction; that of
     * the drive and its laws do not count. */
    LocatedTransient(const ReducedContactModel &model,
                     const double               time_step,
                     TransientDrive             drive,
                     const CycleFriction       &friction,
                     const double               nodal_force,
                     const double               tolerance);

    /** After start(). */
    void set_past(ContactPast past);
    /** Takes these, which must live on, instead of locating changes. */
    void hold(const StepCorrections &corrections);

    /** Solves the contact of each step from the forces after the same step of
     * @p neighbour, which must live on and have as many steps. */
    void set_neighbour(const Orbit &neighbour);

    /** Of all steps so far. */
    const StepCorrections &corrections() const;

  private:
    void            prepare_step(ContactStep &step) override;
    void            finish_step(Eigen::VectorXd &coordinates,
                                Eigen::VectorXd &velocity) override;
    Eigen::VectorXd guess_of_forces() const override;
    /** What jumps of forces in the step add to the coordinates; empty: there
     * are none. Bends add less than the steps are exact to. */
    Eigen::VectorXd by_jumps(const ChangesInStep &changes) const;
    /** What bends and jumps add to the velocities. */
    Eigen::VectorXd beside_lines() const;

    const ReducedContactModel &model;
    const CycleFriction       &friction;
    const double               dt;
    ContactPast                past;
    const StepCorrections     *held      = nullptr;
    const Orbit               *neighbour = nullptr;
    StepCorrections            used;
    Eigen::VectorXd            force_at_start, motion_at_start; // of the step
  };
} // namespace squeal

#endif
