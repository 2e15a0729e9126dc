// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_cycle_period_derivative_h
#define squeal_cycle_period_derivative_h

#include <squeal/cycle/cycle_friction.h>
#include <squeal/cycle/orbit.h>

namespace squeal
{
  /** What a derivative takes changes of status within a step for. */
  enum class StatusChanges
  {
    located, /**< they move with the motion */
    held     /**< the corrections of the steps stay as they are: the exact
                derivative of such steps */
  };

  /**
   * d (q, v, lambda at @p rows) at the end of @p orbit over the same at its
   * start, by the linearised steps between the changes of status: open nodes
   * keep lambda = 0; closed ones keep u_n; sticking ones keep all of u; at
   * slipping ones the friction follows mu lambda_n and turns with the slip s,
   * d lambda_t = mu d dlambda_n + (mu lambda_n/|s|) (1 - d d^T) ds, d = s/|s|.
   *
   * Changes are where ChangesInStep has them. There a disturbance of a force
   * jumps, and what a node that closes slips from moves along with the time at
   * which it closes. Of second order in the step.
   *
   * Where a force jumps, the time at which it does so moves with the forces
   * before, and the impulse with it.
   */
  Eigen::MatrixXd period_derivative(const ReducedContactModel &model,
                                    const CycleFriction       &friction,
                                    const Orbit               &orbit,
                                    const std::vector<int>    &rows,
                                    const StatusChanges        changes);
} // namespace squeal

#endif
