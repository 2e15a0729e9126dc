// SPDX-License-Identifier: LGPL-2.1-or-later

// Correlations, ranks, areas under curves, thresholds, probabilities, powers
// and shares of lines of cells have the values that tables and small examples
// give.
#include <squeal/tribology/statistics/association.h>
#include <squeal/tribology/statistics/cell_lags.h>
#include <squeal/tribology/statistics/link_test.h>

#include <cmath>
#include <numeric>

#include "check.h"

using namespace squeal;
using namespace squeal::testing;
using namespace squeal::tribology;

namespace
{
  void
  associations()
  {
    const std::vector<double> x = {1, 2, 3, 4, 5}, y = {2, 1, 4, 3, 5};
    check_close(pearson(x, y), .8, 1e-12, "Pearson");
    check_close(spearman({1, 10, 100, 1000, 1e4}, y), .8, 1e-12, "Spearman");
    check(std::isnan(pearson({1, 1, 1}, {1, 2, 3})), "a constant has none");
    check(ranks({3, 1, 3, 2}) == std::vector<double>({3.5, 1, 3.5, 2}),
          "ranks of equal values");
    check_close(
      roc_auc({.1, .4, .35, .8}, {0, 0, 1, 1}, 0.), .75, 1e-12, "AUC");
    check(roc_auc({1, 1, 1, 1}, {0, 1, 0, 1}, 0.) == .5, "AUC of no knowledge");
    std::vector<double> up(100), down(100);
    std::iota(up.begin(), up.end(), 0.);
    for (unsigned int i = 0; i < 100; ++i)
      down[i] = 99. - i;
    check(top_decile_overlap(up, up) == 1. &&
            top_decile_overlap(up, down) == 0.,
          "overlap of the top tenth");
    check_close(top_decile_overlap(up, std::vector<double>(100, 1.)),
                .1,
                1e-12,
                "equal values: chance");
    check(feature_threshold({0, 0, 1, 2}) == 0. &&
            feature_threshold({1, 2, 3, 4}) == 2.,
          "threshold of a feature");
  }

  void
  probabilities()
  {
    // r = 0.5, n = 20: t = 2.449490 with 18 degrees of freedom
    check_close(correlation_p_value(.5, 20.), .02477, 1e-3, "Student's t");
    check(correlation_p_value(.9, 3.) == 1. &&
            correlation_p_value(1., 20.) == 0.,
          "too few pairs, perfect pairs");
    check_close(
      correlation_power(.3, 85., .05), .80, 2e-2, "85 pairs find 0.3");
    check(correlation_power(.3, 2., .05) == .05, "no pairs, no power");
    const auto [a, b] = rate_interval(50, 1000);
    check_close(a, .0381, 5e-3, "Wilson, lower");
    check_close(b, .0653, 5e-3, "Wilson, upper");
    const std::vector<double> adjusted = holm({.01, .04, .03, .005});
    const std::vector<double> expected = {.03, .06, .06, .02};
    for (unsigned int i = 0; i < 4; ++i)
      check_close(adjusted[i], expected[i], 1e-12, "Holm");
  }

  void
  lines_of_cells()
  {
    const CellLags lags({{{0, 0}}, {{1, 0}}, {{0, 1}}, {{1, 1}}});
    check_close(lags.largest_share_of_line(Eigen::Vector4d(1., 2., 3., 4.)),
                .7,
                1e-12,
                "the second row carries 7 of 10");
    check_close(lags.largest_share_of_line(Eigen::Vector4d(5., -1., 5., 1.)),
                1.,
                1e-12,
                "the first column carries all");
  }
} // namespace



int
main()
{
  lines_of_cells();
  associations();
  probabilities();
}
