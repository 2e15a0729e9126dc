// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_cycle_period_map_h
#define squeal_cycle_period_map_h

#include <squeal/contact/pressure_moments.h>
#include <squeal/cycle/period_derivative.h>
#include <squeal/transient/transient_integrator.h>

#include <memory>
#include <vector>

namespace squeal
{
  /**
   * The motion of a reduced contact model over a time under constant loads,
   * speeds and coefficients of friction, by the steps of LocatedTransient, and
   * its derivative with respect to where it starts.
   */
  class PeriodMap
  {
  public:
    /** References are kept. @p friction: mu >= 0 at all nodes. @p speed: that
     * the nodes' are measured by, m/s. @p nodal_force: N, that residuals of the
     * contact are measured in. @p nodes_of_pairs: how many nodes the first pair
     * has, the second one and so on; empty: there is one pair. @p moments: of
     * each pair; empty: their moments are not looked at. */
    PeriodMap(const ReducedContactModel &model,
              const double               friction,
              const double               speed,
              const double               nodal_force,
              const double               tolerance = 1e-10);
    PeriodMap(const ReducedContactModel   &model,
              CycleFriction                friction,
              const double                 nodal_force,
              const double                 tolerance      = 1e-10,
              std::vector<unsigned int>    nodes_of_pairs = {},
              std::vector<PressureMoments> moments        = {});

    /** @p past: of the start; changes of status in the first steps are located
     * where it is known, or are those of @p held. @p neighbour: a motion nearby,
     * whose forces the contact is solved from where it has as many steps; the
     * solution is the same to the tolerance and found sooner. Throws
     * ComputationError where a step has no solution, InputError for steps that
     * are too long. */
    Orbit run(const MotionState     &start,
              const double           time,
              const unsigned int     n_steps,
              const ContactPast     &past      = {},
              const StepCorrections *held      = nullptr,
              const Orbit           *neighbour = nullptr) const;

    /** The same with changes of status at the ends of steps, as those of a
     * ReducedTransient: of first order there, but no motion with many impacts
     * gains energy by it. Under a further @p force, if it is given, whose course
     * in time counts from the start. */
    Orbit run_plainly(const MotionState           &start,
                      const double                 time,
                      const unsigned int           n_steps,
                      const ContactPast           &past,
                      const TransientDrive::Force *force = nullptr) const;

    /** Rows of the forces that count at the start and the end of @p orbit:
     * those of nodes closed at one of them. */
    std::vector<int> closed_rows(const Orbit &orbit) const;

    /** See period_derivative(). */
    Eigen::MatrixXd derivative(
      const Orbit            &orbit,
      const std::vector<int> &rows,
      const StatusChanges     changes = StatusChanges::located) const;

    /** d (q, v)/dt at a state, rows as there. */
    Eigen::VectorXd acceleration(const MotionState &state) const;

    const ReducedContactModel &
    reduced_model() const
    {
      return model;
    }
    double
    sliding_speed() const
    {
      return friction.speed;
    }
    const CycleFriction &
    law_of_friction() const
    {
      return friction;
    }
    const std::vector<unsigned int> &
    nodes_of_pairs() const
    {
      return pairs;
    }
    const std::vector<PressureMoments> &
    moments_of_pairs() const
    {
      return moments;
    }

  private:
    Orbit run_by(const TransientDrive  &drive,
                 const MotionState     &start,
                 const double           time,
                 const unsigned int     n_steps,
                 const ContactPast     &past,
                 const StepCorrections *held,
                 const Orbit           *neighbour,
                 const double           contact_tolerance) const;

    const ReducedContactModel   &model;
    TransientDrive               drive;
    CycleFriction                friction;
    const double                 nodal_force, tolerance;
    std::vector<unsigned int>    pairs;   /**< their numbers of nodes */
    std::vector<PressureMoments> moments; /**< of each; empty: not known */
  };
} // namespace squeal

#endif
