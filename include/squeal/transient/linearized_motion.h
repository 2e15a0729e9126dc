// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_transient_linearized_motion_h
#define squeal_transient_linearized_motion_h

#include <squeal/contact/friction_law.h>
#include <squeal/transient/steady_sliding.h>

#include <Eigen/Dense>

#include <vector>

namespace squeal
{
  /** Eigenvalues of the motion about steady sliding with its contact state,
   * and the left vectors that pick the amplitude of each out of a motion. */
  struct LinearizedMotion
  {
    Eigen::VectorXcd lambda; /**< sigma + i omega, omega >= 0, ascending in
                                omega */
    /** Rows l_k: l_k (q; v; the forces of `rows_viscous`, less what the normal
     * forces limit them by) is the amplitude of pair k in a motion, scaled so
     * that an eigenmotion of kinetic energy amplitude 1 J has amplitude 1.
     * Where two pairs have coalesced the scale is lost in rounding, but their
     * amplitudes still grow by lambda. */
    Eigen::MatrixXcd left;
    /** Columns: the eigenmotions of amplitude 1, left * right has a unit
     * diagonal. */
    Eigen::MatrixXcd right;
    /** Of the eigenvalues, |l_k| |x_k| in balanced units: 1 of motions at
     * right angles, at a coalescence the most that double precision tells
     * apart, 4.5e15. */
    Eigen::VectorXd condition;
    /** What a relative change of all slopes dmu/d|v_t| < 0 adds to each
     * eigenvalue, over it, 1/s; zero where friction nowhere falls. */
    Eigen::VectorXcd by_slope;
    /** The same of a relative change of what dashpots the nodes are: across
     * the sliding, and along it where friction rises. */
    Eigen::VectorXcd by_viscosity;
    /** Which of all nodal forces are viscous ones: across the sliding at the
     * nodes that slip with friction, along it at those whose friction rises
     * with the slip rate. */
    std::vector<int> rows_viscous;
    /** Of each, the mu by which the normal force of its node adds to it: along
     * the sliding. */
    Eigen::VectorXd limit_by_normal;

    /** Amplitudes of all pairs in what a motion is away from @p steady. */
    Eigen::VectorXcd amplitudes(const SteadySliding   &steady,
                                const Eigen::VectorXd &coordinates,
                                const Eigen::VectorXd &velocities,
                                const Eigen::VectorXd &forces) const;
  };

  /**
   * Closed nodes keep u_n. Nodes that stick keep all of u; the friction of
   * those that slip follows the normal force and turns with the slip: along the
   * sliding mu lambda_n and p_0 dmu/d|v_t| times the
   * slip rate there, across it mu p_0/|V| times the slip rate across. Nodes of
   * a pair at rest whose friction rises from zero have p_0 dmu/d|v_t| times the
   * slip rate in both directions.
   *
   * Where friction falls, the slip rates along and across the sliding leave out
   * what the slope itself does to the massless flexibility G: that alone would
   * grow at the rate 1/(G p_0 |dmu/dv|), which no body with mass does.
   */
  LinearizedMotion linearize(const ReducedContactModel &model,
                             const SteadySliding       &steady,
                             const NodalFriction       &friction,
                             const double               speed);

  /** With one coefficient at all nodes and slip rates. */
  LinearizedMotion linearize(const ReducedContactModel &model,
                             const SteadySliding       &steady,
                             const double               friction,
                             const double               speed);

  /**
   * What the inertia and damping of the flexibility, which the reduced model
   * leaves out, would add to the eigenvalues of @p linear, 1/s, to first order:
   * those of all unknowns less these. Zero where the model does not know them.
   */
  Eigen::VectorXcd reduction_error(const ReducedContactModel &model,
                                   const SteadySliding       &steady,
                                   const NodalFriction       &friction,
                                   const double               speed,
                                   const LinearizedMotion    &linear);
} // namespace squeal

#endif
