// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_images_boosted_trees_h
#define squeal_tribology_images_boosted_trees_h

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <vector>

namespace squeal::tribology
{
  /** Log odds as a sum over small decision trees. Each tree asks three
   * questions in turn, whether a feature reaches a cut, and what it asks next
   * depends on the answers. */
  struct BoostedTrees
  {
    struct Tree
    {
      static constexpr int depth = 3, n_leaves = 1 << depth;

      /** Of each question, level by level: those that follow question i are
       * 2 i + 1 (no) and 2 i + 2 (yes). */
      std::array<std::uint8_t, n_leaves - 1> feature{};
      std::array<float, n_leaves - 1>        cut{};
      std::array<std::int16_t, n_leaves>     leaf{}; /**< in steps of unit */
    };

    static constexpr double unit  = 1e-4; /**< log odds */
    static constexpr float  never = 1e9F; /**< a cut that nothing reaches */

    double            offset = 0.; /**< log odds without any tree */
    std::vector<Tree> trees;

    /** Log odds of features in the order that the trees were fitted to. */
    template <typename Features>
    double
    operator()(const Features &features) const
    {
      int sum = 0;
      for (const Tree &tree : trees)
        {
          int i = 0;
          for (int level = 0; level < Tree::depth; ++level)
            i =
              2 * i + 1 + int(float(features[tree.feature[i]]) >= tree.cut[i]);
          sum += tree.leaf[i - (Tree::n_leaves - 1)];
        }
      return offset + unit * sum;
    }

    /** A leaf as it is stored. */
    static std::int16_t
    stored(const double log_odds)
    {
      return std::int16_t(std::lround(log_odds / unit));
    }

    /** A cut as it is written into a table. */
    static float
    rounded(const float cut)
    {
      char text[32];
      std::snprintf(text, sizeof text, "%.4g", double(cut));
      return std::strtof(text, nullptr);
    }
  };
} // namespace squeal::tribology

#endif
