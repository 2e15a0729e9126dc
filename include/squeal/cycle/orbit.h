// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_cycle_orbit_h
#define squeal_cycle_orbit_h

#include <squeal/transient/transient_integrator.h>

#include <vector>

namespace squeal
{
  /** What the later motion of a reduced model depends on. */
  struct MotionState
  {
    Eigen::VectorXd coordinates; /**< q of the modes */
    Eigen::VectorXd velocities;  /**< q' */
    Eigen::VectorXd forces;      /**< lambda, N, three a node */
  };

  /** What the contact nodes did in the two steps before a time; where changes
   * of status lie within the next step is told from it. */
  struct ContactPast
  {
    Eigen::VectorXd force_change;             /**< N, in the last step */
    Eigen::VectorXd motion_change;            /**< m, in the last step */
    Eigen::VectorXd motion_change_before;     /**< m, in the one before */
    std::vector<ContactStatus> status;        /**< of the last step */
    std::vector<ContactStatus> status_before; /**< of the one before */

    /** False at a start of which nothing is known. */
    bool
    is_known() const
    {
      return !status_before.empty();
    }
  };

  /** What located changes of status add to the steps of a motion. */
  struct StepCorrections
  {
    /** Of every step and node, m, two a node: motion before slip counts. */
    std::vector<Eigen::VectorXd> slip;
    /** Of every step, of the modes' coordinates at its end; empty: nothing. */
    std::vector<Eigen::VectorXd> position;
    /** Of every step, of the modes' velocities at its end. */
    std::vector<Eigen::VectorXd> velocity;
  };

  /** A motion of equal steps from time 0 on. */
  struct Orbit
  {
    double          step = 0.; /**< s */
    ContactPast     past;      /**< of the start, as the steps have used it */
    StepCorrections corrections;
    /** At the start and after every step. */
    std::vector<MotionState>     states;
    std::vector<Eigen::VectorXd> motions; /**< B u, m, three a node */
    /** After every step. */
    std::vector<std::vector<ContactStatus>> status;
    EnergyLedger                            ledger; /**< at the end */
    unsigned int                            n_iterations = 0;

    unsigned int
    n_steps() const
    {
      return status.size();
    }
    const MotionState &
    end() const
    {
      return states.back();
    }
    /** Before step @p i, from 0 to n_steps(). */
    ContactPast past_of(const unsigned int i) const;
  };
} // namespace squeal

#endif
