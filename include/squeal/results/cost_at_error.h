// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_results_cost_at_error_h
#define squeal_results_cost_at_error_h

#include <optional>
#include <vector>

namespace squeal
{
  /** What a ladder of ever finer rungs must spend to reach an error. */
  struct CostAtError
  {
    double cost;         /**< in the unit of the rungs' costs */
    bool   extrapolated; /**< the finest rung is above the error */
  };

  /**
   * Cost at which the error falls to @p goal and stays there: on the power law
   * between the two rungs about it, or on that of the last two rungs beyond
   * the finest. @p costs (positive) and @p errors, in any order of cost, have
   * one entry a rung; where the better of the two rungs has no error it is the
   * cost of that one. Nothing if there are fewer than two rungs, if every rung
   * is at or below the goal (the cost is then only bounded), or if the errors
   * do not fall towards a goal beyond the finest rung, or if it lies beyond a
   * thousand times the cost of the dearest one.
   */
  std::optional<CostAtError> cost_at_error(const std::vector<double> &costs,
                                           const std::vector<double> &errors,
                                           double                     goal);
} // namespace squeal

#endif
