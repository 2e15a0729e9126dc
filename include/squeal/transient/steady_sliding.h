// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_transient_steady_sliding_h
#define squeal_transient_steady_sliding_h

#include <squeal/contact/friction_law.h>
#include <squeal/transient/contact_solver.h>
#include <squeal/transient/reduced_contact_model.h>

namespace squeal
{
  /** Steady sliding under a constant load: everything at rest but the targets,
   * which slide on; all closed nodes of sliding pairs slip. In pairs at rest
   * nothing moves: their closed nodes stick, or, without friction, slip. */
  struct SteadySliding
  {
    Eigen::VectorXd            coordinates; /**< q */
    Eigen::VectorXd            forces;      /**< lambda, N, three a node */
    Eigen::VectorXd            motion;      /**< B u, m, three a node */
    std::vector<ContactStatus> status;
    ContactReport              report;

    unsigned int n_closed() const;
    unsigned int n_with(const ContactStatus status) const;
    /** Sum of the nodal forces: normal, along and across the sliding, N. */
    Eigen::Vector3d resultant() const;
  };

  /**
   * Solves K u + B^T lambda = f with Signorini's and Coulomb's law for the
   * share @p load_factor of the load and speeds > 0, whose common size does not
   * matter. Throws ComputationError where there is no steady sliding (the
   * friction wedges or sprags).
   *
   * What sticks in a pair at rest depends on the order of things. Where the
   * model has such pairs (nodes with a speed ratio of 0) the loads come on
   * first, while the friction of the sliding pairs is zero, then that friction
   * grows to its full size, both in ten equal steps.
   */
  SteadySliding steady_sliding(const ReducedContactModel &model,
                               const double               friction,
                               const double               load_factor = 1.,
                               const double               tolerance   = 1e-10);

  /** The same with the coefficient @p friction of every node. */
  SteadySliding steady_sliding(const ReducedContactModel &model,
                               const Eigen::VectorXd     &friction,
                               const double               load_factor = 1.,
                               const double               tolerance   = 1e-10);

  /**
   * A target at rest pressed on in @p n_steps equal shares of the load: nodes
   * stick or slip by how the bodies deform. One state a step, the last under
   * the full load. Throws ComputationError.
   */
  std::vector<SteadySliding> press_at_rest(const ReducedContactModel &model,
                                           const double               friction,
                                           const unsigned int         n_steps,
                                           const double tolerance = 1e-10);

  /** The same with the coefficient @p friction of every node. */
  std::vector<SteadySliding> press_at_rest(const ReducedContactModel &model,
                                           const Eigen::VectorXd     &friction,
                                           const unsigned int         n_steps,
                                           const double tolerance = 1e-10);

  /** Eigenvalues of the motion about steady sliding with its contact state,
   * and the left vectors that pick the amplitude of each out of a motion. */
  struct LinearizedMotion
  {
    Eigen::VectorXcd lambda; /**< sigma + i omega, omega >= 0, ascending in
                                omega */
    /** Rows l_k: l_k (q; v; lambda across the sliding at the nodes that slip
     * with friction) is the amplitude of pair k in a motion, scaled so that an
     * eigenmotion of kinetic energy amplitude 1 J has amplitude 1. Where two
     * pairs have coalesced the scale is lost in rounding, but their amplitudes
     * still grow by lambda. */
    Eigen::MatrixXcd left;
    /** Columns: the eigenmotions of amplitude 1, left * right has a unit
     * diagonal. */
    Eigen::MatrixXcd right;
    /** Of the eigenvalues, |l_k| |x_k| in balanced units: 1 of motions at
     * right angles, at a coalescence the most that double precision tells
     * apart, 4.5e15. */
    Eigen::VectorXd condition;
    /** What lambda across the sliding has part in its own rate, 1/s. */
    Eigen::MatrixXd across;
    /** Which of all nodal forces those are. */
    std::vector<int> rows_across;

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
   * slip rate there, across it mu p_0/|V| times the slip rate across.
   *
   * The slip rate that the slope sees leaves out what the slope itself does to
   * the massless flexibility G: with a falling law that alone would grow at the
   * rate 1/(G p_0 |dmu/dv|), which no body with mass does.
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
} // namespace squeal

#endif
