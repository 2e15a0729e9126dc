// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_analyses_limit_cycle_pairs_to_follow_h
#define squeal_analyses_limit_cycle_pairs_to_follow_h

#include <squeal/parameters/analysis_parameters.h>
#include <squeal/parameters/limit_cycle_parameters.h>
#include <squeal/transient/linearized_motion.h>

#include <vector>

namespace squeal
{
  /** The growing pairs of @p band that cycles are sought from, the one that was
   * asked for first, without `Every growing pair` that one alone. */
  std::vector<Eigen::Index> pairs_to_follow(
    const LinearizedMotion     &linear,
    const EigenParameters      &band,
    const LimitCycleParameters &settings);
} // namespace squeal

#endif
