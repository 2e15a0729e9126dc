// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_transient_steady_sliding_h
#define squeal_transient_steady_sliding_h

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
} // namespace squeal

#endif
