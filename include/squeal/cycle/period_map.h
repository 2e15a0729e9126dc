// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_cycle_period_map_h
#define squeal_cycle_period_map_h

#include <squeal/transient/reduced_transient.h>

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

  /** A motion of equal steps from time 0 on. */
  struct Orbit
  {
    double step = 0.; /**< s */
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
  };

  /**
   * The motion of a reduced contact model over a time under constant loads,
   * speeds and coefficients of friction, by the steps of ReducedTransient, and
   * its derivative with respect to where it starts.
   *
   * The derivative is that of the discrete steps with the statuses they have:
   * open nodes keep lambda = 0; closed ones keep u_n; sticking ones keep all of
   * u; at slipping ones the friction follows mu lambda_n and turns with the
   * slip s, d lambda_t = mu d dlambda_n + (mu lambda_n/|s|) (1 - d d^T) ds,
   * d = s/|s|. At a step that ends exactly where a status changes it is one of
   * several (a generalised Jacobian).
   */
  class PeriodMap
  {
  public:
    /** References are kept. @p friction: mu >= 0 at all nodes. @p speed: that
     * the nodes' are measured by, m/s. @p nodal_force: N, that residuals of the
     * contact are measured in. */
    PeriodMap(const ReducedContactModel &model,
              const double               friction,
              const double               speed,
              const double               nodal_force,
              const double               tolerance = 1e-10);
    /** With a coefficient a pair: constant laws only. */
    PeriodMap(const ReducedContactModel          &model,
              std::shared_ptr<const FrictionLaws> laws,
              const double                        speed,
              const double                        nodal_force,
              const double                        tolerance = 1e-10);

    /** Throws ComputationError where a step has no solution, InputError for
     * steps that are too long. */
    Orbit run(const MotionState &start,
              const double       time,
              const unsigned int n_steps) const;

    /** Rows of the forces that count at the start and the end of @p orbit:
     * those of nodes closed at one of them. */
    std::vector<int> closed_rows(const Orbit &orbit) const;

    /** What a node that opens or closes does to the derivative of its step. */
    enum class Changes
    {
      at_steps, /**< of the discrete steps as they are, for Newton's method */
      located   /**< of the motion that they stand for: a force that a
                     disturbance adds is there from where the node closes to
                     where it opens, within the step. The orbit is periodic.
                     Without that multipliers are of first order in the step */
    };
    /** d (q, v, lambda at @p rows)_end / d (q, v, lambda at @p rows)_start. */
    Eigen::MatrixXd derivative(const Orbit            &orbit,
                               const std::vector<int> &rows,
                               const Changes           changes) const;

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
      return speed;
    }
    /** mu of every node. */
    const Eigen::VectorXd &
    friction_coefficients() const
    {
      return friction;
    }

  private:
    const ReducedContactModel &model;
    TransientDrive             drive;
    Eigen::VectorXd            friction;
    const double               speed, nodal_force, tolerance;
  };
} // namespace squeal

#endif
