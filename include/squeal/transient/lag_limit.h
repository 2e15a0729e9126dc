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

  /** What lag_limit() takes of a friction that falls by @p fall and elsewhere
   * rises by @p rise with the slip rate, both s/m and >= 0: rising friction
   * needs twice the step. */
  double lag_slope(const double fall, const double rise);

  /**
   * A node that slips on the flexibility G of @p model, m/N, under the normal
   * force p, N, and friction with the slope mu', s/m, is held by the lag of a
   * LaggedFriction only in steps dt that are long enough. With
   * a = G p |mu'| / dt its slip follows s_2 - a s_1 + a s_0 = 0 where friction
   * falls, which grows from step to step for a > 1, and
   * s_2 + a s_1 - a s_0 = 0 where it rises, which does so with alternating
   * signs for a > 1/2. The shortest step is therefore G p @p slope with the
   * slope of lag_slope(). For many nodes it comes from the largest eigenvalue
   * of G along the sliding, times p slope. p is that of @p steady; nodes that
   * are open there are left out.
   *
   * @param slope  of every node, s/m and >= 0
   * @param step   s, that n_above is counted by
   */
  LagLimit lag_limit(const ReducedContactModel &model,
                     const SteadySliding       &steady,
                     const Eigen::VectorXd     &slope,
                     const double               step);
} // namespace squeal

#endif
