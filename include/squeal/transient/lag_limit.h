// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_transient_lag_limit_h
#define squeal_transient_lag_limit_h

#include <squeal/transient/steady_sliding.h>

namespace squeal
{
  /** How short steps with lagged friction may be, see lag_limit(). */
  struct LagLimit
  {
    double       shortest = 0.; /**< s; 0: any */
    unsigned int n_above  = 0;  /**< nodes that alone need longer steps */
  };

  /**
   * A node that slips on the flexibility G of @p model, m/N, under the normal
   * force p, N, and friction that falls by @p fall, s/m and >= 0, is held by
   * the lag of a LaggedFriction only in steps longer than G p fall: its slip
   * follows s_2 - a s_1 + a s_0 = 0 with a = G p fall / dt, which grows from
   * step to step for a > 1. For many nodes a comes from the largest eigenvalue
   * of G along the sliding, times p fall. p is that of @p steady; nodes that do
   * not slip there are left out.
   *
   * @param fall  of every node, s/m
   * @param step  s, that n_above is counted by
   */
  LagLimit lag_limit(const ReducedContactModel &model,
                     const SteadySliding       &steady,
                     const Eigen::VectorXd     &fall,
                     const double               step);
} // namespace squeal

#endif
