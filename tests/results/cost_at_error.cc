// SPDX-License-Identifier: LGPL-2.1-or-later
// The cost of an error is read off the power law of the rungs about it.
#include <squeal/results/cost_at_error.h>

#include <cmath>

#include "check.h"

using namespace squeal;
using namespace squeal::testing;

namespace
{
  void
  check_cost(const std::optional<CostAtError> &found,
             const double                      cost,
             const bool                        extrapolated,
             const std::string                &claim)
  {
    check(found.has_value(), claim + ": there is a cost");
    check(std::abs(found->cost / cost - 1.) < 1e-12,
          claim + ": " + std::to_string(found->cost));
    check(found->extrapolated == extrapolated, claim + ": extrapolated or not");
  }
} // namespace



int
main()
{
  // error = 100 / cost^2 on the first two rungs, 1 / cost from there on.
  const std::vector<double> costs  = {10., 100., 1000.},
                            errors = {1., 1e-2, 1e-3};
  check_cost(cost_at_error(costs, errors, .04), 50., false, "between rungs");
  check_cost(cost_at_error(costs, errors, .004), 250., false, "second law");
  check_cost(cost_at_error(costs, errors, .01), 100., false, "on a rung");
  check_cost(cost_at_error(costs, errors, 1e-4), 1e4, true, "beyond the last");
  check_cost(cost_at_error({1000., 10., 100.}, {1e-3, 1., 1e-2}, .04),
             50.,
             false,
             "rungs in any order");
  check_cost(cost_at_error({1., 10., 100., 1000.}, {1., .1, 1., .01}, .1),
             std::sqrt(1e5),
             false,
             "a rung that is good by chance does not count");
  check(!cost_at_error(costs, errors, 2.), "every rung is good: only a bound");
  check(!cost_at_error({10.}, {1.}, .1), "one rung has no law");
  check(cost_at_error(costs, errors, 1.01e-6).has_value() &&
          !cost_at_error(costs, errors, .99e-6),
        "a law of two rungs tells no more than three decades");
  check(!cost_at_error({10., 100.}, {1e-2, 1.}, 1e-3), "errors that rise");
  check_cost(cost_at_error({10., 100.}, {1., 0.}, .1),
             100.,
             false,
             "a rung without an error is enough");
  return 0;
}
