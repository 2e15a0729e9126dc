// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/results/cost_at_error.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace squeal
{
  namespace
  {
    /** Over the cost of the dearest rung: no power law of two rungs is good for
     * more decades. */
    constexpr double farthest_cost = 1e3;
  } // namespace

  std::optional<CostAtError>
  cost_at_error(const std::vector<double> &costs,
                const std::vector<double> &errors,
                const double               goal)
  {
    Assert(costs.size() == errors.size() && goal > 0.,
           dealii::ExcInternalError());
    std::vector<std::pair<double, double>> rungs; // logarithms
    for (std::size_t i = 0; i < costs.size(); ++i)
      rungs.emplace_back(std::log(costs[i]), std::log(errors[i]));
    std::sort(rungs.begin(), rungs.end());

    // The first rung from which on all are good enough.
    std::size_t good = rungs.size();
    while (good > 0 && rungs[good - 1].second <= std::log(goal))
      --good;
    if (rungs.size() < 2 || good == 0)
      return {};
    const bool  beyond = good == rungs.size();
    const auto &to     = rungs[beyond ? good - 1 : good];
    const auto &from   = rungs[beyond ? good - 2 : good - 1];
    // No law leads to an error of zero: what its rung costs is enough.
    if (std::isinf(to.second))
      return CostAtError{std::exp(to.first), false};
    const double slope = (to.second - from.second) / (to.first - from.first);
    if (!(slope < 0.))
      return {};
    const double cost = from.first + (std::log(goal) - from.second) / slope;
    if (cost > rungs.back().first + std::log(farthest_cost))
      return {};
    return CostAtError{std::exp(cost), beyond};
  }
} // namespace squeal
