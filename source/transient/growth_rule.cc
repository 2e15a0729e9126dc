// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/transient/growth_rule.h>

#include <algorithm>
#include <cmath>

namespace squeal
{
  namespace
  {
    constexpr double widest_share = 0.5, always_narrow = 10.; // -, 1/s
  }                                                           // namespace



  bool
  tells_a_rate(const GrowthFit &fit)
  {
    return fit.is_valid && std::isfinite(fit.rate) &&
           fit.n_periods() >= fewest_periods &&
           fit.rate_ci <=
             std::max(widest_share * std::abs(fit.rate), always_narrow);
  }
} // namespace squeal
