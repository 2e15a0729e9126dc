// SPDX-License-Identifier: LGPL-2.1-or-later
// The assignment found is the cheapest of all.
#include <squeal/base/assignment.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <set>

#include "check.h"
#include "worst.h"

using namespace squeal;
using namespace squeal::testing;

namespace
{
  using Costs = std::vector<std::vector<double>>;

  double
  sum(const Costs &costs, const std::vector<int> &column_of)
  {
    double total = 0.;
    for (std::size_t row = 0; row < costs.size(); ++row)
      if (column_of[row] >= 0)
        total += costs[row][column_of[row]];
    return total;
  }

  /** Tries every permutation of the longer side. */
  double
  cheapest(const Costs &costs)
  {
    const std::size_t n = costs.size(), m = costs.front().size();
    std::vector<int>  order(std::max(n, m));
    std::iota(order.begin(), order.end(), 0);
    Worst best;
    do
      {
        double total = 0.;
        for (std::size_t i = 0; i < std::min(n, m); ++i)
          total += n <= m ? costs[i][order[i]] : costs[order[i]][i];
        best.add(total);
      }
    while (std::next_permutation(order.begin(), order.end()));
    return best.smallest();
  }
} // namespace

int
main()
{
  check(smallest_assignment({{1., 0.}, {0., 5.}}) == std::vector<int>({1, 0}),
        "two by two");
  check(smallest_assignment({}).empty() &&
          smallest_assignment({{}, {}}) == std::vector<int>({-1, -1}),
        "nothing to assign");

  std::mt19937                           random(3);
  std::uniform_real_distribution<double> unit(-1., 1.);
  for (int round = 0; round < 200; ++round)
    {
      const std::size_t n = 1 + random() % 6, m = 1 + random() % 6;
      Costs             costs(n, std::vector<double>(m));
      for (auto &row : costs)
        for (double &cost : row)
          // ties are as likely as differences
          cost = round % 2 == 0 ? unit(random) : random() % 3;
      const std::vector<int> column_of = smallest_assignment(costs);
      std::multiset<int>     used(column_of.begin(), column_of.end());
      used.erase(-1);
      const bool once =
        used.size() == std::min(n, m) &&
        std::set<int>(used.begin(), used.end()).size() == used.size();
      if (!once ||
          !(std::abs(sum(costs, column_of) - cheapest(costs)) <= 1e-12))
        check(false,
              "round " + std::to_string(round) + ": each once and cheapest");
    }
  check(true, "200 random tables: each row and column once, cheapest sum");
}
