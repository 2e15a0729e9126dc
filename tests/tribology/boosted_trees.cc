// SPDX-License-Identifier: LGPL-2.1-or-later

// Trees answer what they are asked, learn what no single feature tells, learn
// little from noise, and the table that is shipped fits the features.
#include <squeal/tribology/images/line_judge.h>

#include <opencv2/core.hpp>

#include <cmath>
#include <cstdio>

#include "check.h"
#include "tribology/fit_trees.h"

using namespace squeal::testing;
using namespace squeal::tribology;

namespace
{
  constexpr int n_features = 4, n_trees = 100;

  /** Numbers from 0 to 1. With @p has_rule yes means that just one of the
   * first two exceeds a half, else it is a coin. */
  TreeData
  draw_data(const int seed, const int n_rows, const bool has_rule)
  {
    cv::RNG  random(std::uint64_t(seed) + 1);
    TreeData data;
    data.n_features = n_features;
    for (int r = 0; r < n_rows; ++r)
      {
        std::array<float, n_features> f{};
        for (float &value : f)
          value = random.uniform(0.F, 1.F);
        data.features.insert(data.features.end(), f.begin(), f.end());
        data.is_true.push_back(has_rule ? (f[0] > 0.5F) != (f[1] > 0.5F)
                                        : random.uniform(0, 2) == 1);
        data.weights.push_back(1.F);
      }
    return data;
  }



  /** Share of rows that trees are right about. */
  double
  right(const BoostedTrees &trees, const TreeData &data)
  {
    double n = 0.;
    for (std::size_t r = 0; r < data.is_true.size(); ++r)
      n +=
        (trees(&data.features[r * n_features]) > 0.) == (data.is_true[r] != 0);
    return n / double(data.is_true.size());
  }



  void
  check_answers()
  {
    BoostedTrees       trees;
    BoostedTrees::Tree tree;
    tree.feature = {{0, 1, 2, 0, 0, 0, 0}};
    tree.cut     = {{1.F, 2.F, 3.F, 0.F, 0.F, 0.F, BoostedTrees::never}};
    for (int k = 0; k < BoostedTrees::Tree::n_leaves; ++k)
      tree.leaf[k] = BoostedTrees::stored(0.1 * k);
    trees.offset = 10.;
    trees.trees  = {tree};
    using Row    = std::array<double, 3>;
    check(std::abs(trees(Row{{-1., 0., 0.}}) - 10.) < 1e-9, "no, no, no");
    check(std::abs(trees(Row{{0.5, 2., 0.}}) - 10.3) < 1e-9,
          "no, yes at the cut itself, yes");
    check(std::abs(trees(Row{{5., 0., 9.}}) - 10.6) < 1e-9,
          "yes, yes, and nothing reaches the last cut");
  }



  void
  check_learning()
  {
    const TreeData     known = draw_data(1, 4000, true);
    const BoostedTrees rule  = TreeFit(known).fit(n_trees);
    const double       share = right(rule, draw_data(2, 4000, true));
    std::printf("right about %.3f of rows that were not seen\n", share);
    check(share > 0.95, "trees learn what no single feature tells");
    const BoostedTrees again = TreeFit(known).fit(n_trees);
    check(rule(&known.features[0]) == again(&known.features[0]),
          "the same numbers in every run");
    const TreeData     coin  = draw_data(3, 4000, false);
    const BoostedTrees noise = TreeFit(coin).fit(n_trees);
    double             sum   = 0.;
    for (std::size_t r = 0; r < coin.is_true.size(); ++r)
      sum += std::pow(noise(&coin.features[r * n_features]), 2);
    const double spread = std::sqrt(sum / double(coin.is_true.size()));
    std::printf("log odds of coins: %.3f (rms)\n", spread);
    check(spread < 0.5, "little is learned from noise");
  }



  void
  check_table(const BoostedTrees &trees, const int n)
  {
    check(trees.trees.size() >= 100, "a table has trees");
    for (const BoostedTrees::Tree &tree : trees.trees)
      for (const int f : tree.feature)
        check(f < n, "a table asks for features that there are");
  }
} // namespace



int
main()
{
  check_answers();
  check_learning();
  check_table(LineJudge::standard().alone, n_own_features);
  check_table(LineJudge::standard().in_context, n_all_features);
  for (const double value : LineJudge::standard().typical)
    check(std::isfinite(value), "the typical crack has all features");
  check(LineJudge::standard().typical[0] > 2.,
        "its contrast is that of a dark line");
  return 0;
}
