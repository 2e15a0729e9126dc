// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tests_tribology_fit_trees_h
#define squeal_tests_tribology_fit_trees_h

#include <squeal/tribology/images/boosted_trees.h>

#include <opencv2/core.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace squeal::testing
{
  /** What boosted trees are fitted to: rows of features with a yes or no and a
   * weight. */
  struct TreeData
  {
    int                n_features = 0;
    std::vector<float> features; /**< row by row */
    std::vector<char>  is_true;  /**< of each row */
    std::vector<float> weights;  /**< of each row, mean 1 */
  };

  /**
   * Fits trees by Newton's method on the logistic loss, one tree at a time
   * (Friedman 2001). OpenCV's
   * boosting knows neither a learning rate nor a penalty of the leaves, and
   * without them a few specimens are learned by heart. The same numbers in
   * every run.
   */
  class TreeFit
  {
  public:
    explicit TreeFit(const TreeData &data)
      : data(data)
      , n_rows(data.is_true.size())
      , odds(n_rows, 0.)
      , slope(n_rows)
      , curvature(n_rows)
      , leaf(n_rows)
      , random(1)
    {
      find_cuts();
    }

    tribology::BoostedTrees
    fit(const int n_trees)
    {
      tribology::BoostedTrees result;
      result.offset = start();
      for (int i = 0; i < n_trees; ++i)
        result.trees.push_back(add_tree());
      return result;
    }

  private:
    using Tree = tribology::BoostedTrees::Tree;

    static constexpr int    n_bins     = 64;
    static constexpr double rate       = 0.05; // share of a step that is taken
    static constexpr double penalty    = 20.;  // of the squares of the leaves
    static constexpr double least_side = 20.;  // curvature of a leaf
    static constexpr double features_seen = 0.5, rows_seen = 0.7; // by a tree

    struct Sum
    {
      double slope = 0., curvature = 0.;

      void
      add(const Sum &other)
      {
        slope += other.slope;
        curvature += other.curvature;
      }

      double
      gain() const
      {
        return slope * slope / (curvature + penalty);
      }
    };
    using Histogram = std::vector<std::array<Sum, n_bins>>;

    /** Quantiles of each feature, and the bin of each number. */
    void
    find_cuts()
    {
      const std::size_t n = std::size_t(data.n_features);
      cuts.resize(n);
      bins.resize(n);
      for (std::size_t f = 0; f < n; ++f)
        {
          std::vector<float> values(n_rows);
          for (std::size_t r = 0; r < n_rows; ++r)
            values[r] = data.features[r * n + f];
          std::vector<float> sorted = values;
          std::sort(sorted.begin(), sorted.end());
          for (int k = 1; k < n_bins; ++k)
            {
              const float cut = tribology::BoostedTrees::rounded(
                sorted[n_rows * std::size_t(k) / n_bins]);
              if (cuts[f].empty() || cut > cuts[f].back())
                cuts[f].push_back(cut);
            }
          for (const float v : values)
            bins[f].push_back(
              std::uint8_t(std::upper_bound(cuts[f].begin(), cuts[f].end(), v) -
                           cuts[f].begin()));
        }
    }

    /** Log odds of all rows together. */
    double
    start()
    {
      double yes = 0., no = 0.;
      for (std::size_t r = 0; r < n_rows; ++r)
        (data.is_true[r] != 0 ? yes : no) += data.weights[r];
      const double offset = std::log(yes / no);
      std::fill(odds.begin(), odds.end(), offset);
      return offset;
    }

    Tree
    add_tree()
    {
      seen.clear();
      for (std::size_t r = 0; r < n_rows; ++r)
        {
          const double p = 1. / (1. + std::exp(-odds[r]));
          slope[r]       = data.weights[r] * (double(data.is_true[r]) - p);
          curvature[r]   = data.weights[r] * p * (1. - p);
          if (random.uniform(0., 1.) < rows_seen)
            seen.push_back(r);
        }
      std::fill(leaf.begin(), leaf.end(), std::uint8_t(0));
      Tree             tree;
      std::vector<int> features;
      for (int f = 0; f < data.n_features; ++f)
        if (random.uniform(0., 1.) < features_seen)
          features.push_back(f);
      for (int level = 0; level < Tree::depth; ++level)
        split(tree, level, features);
      std::array<Sum, Tree::n_leaves> sums{};
      for (const std::size_t r : seen)
        sums[leaf[r]].add({slope[r], curvature[r]});
      for (int k = 0; k < Tree::n_leaves; ++k)
        tree.leaf[k] = tribology::BoostedTrees::stored(
          rate * sums[k].slope / (sums[k].curvature + penalty));
      for (std::size_t r = 0; r < n_rows; ++r)
        odds[r] += tribology::BoostedTrees::unit * tree.leaf[leaf[r]];
      return tree;
    }

    /** The question that tells most in one leaf of a level. */
    struct Question
    {
      double gain    = -1.;
      int    feature = 0, bin = n_bins;
    };

    /** Asks a question in each leaf of a level. */
    void
    split(Tree &tree, const int level, const std::vector<int> &features)
    {
      const int             n_nodes = 1 << level;
      std::vector<Question> best(n_nodes, Question());
      for (const int f : features)
        {
          const Histogram sums = count(f, n_nodes);
          for (int k = 0; k < n_nodes; ++k)
            improve(best[k], sums[k], f);
        }
      for (int k = 0; k < n_nodes; ++k)
        {
          const Question &q = best[k];
          const int       i = n_nodes - 1 + k;
          tree.feature[i]   = std::uint8_t(q.feature);
          tree.cut[i]       = q.bin < n_bins ? cuts[q.feature][q.bin]
                                             : tribology::BoostedTrees::never;
        }
      for (std::size_t r = 0; r < n_rows; ++r)
        {
          const Question &q = best[leaf[r]];
          leaf[r] = std::uint8_t(2 * leaf[r] + (bins[q.feature][r] > q.bin));
        }
    }

    /** Sums up to each bin. */
    Histogram
    count(const int feature, const int n_nodes) const
    {
      Histogram   sums(n_nodes, std::array<Sum, n_bins>{});
      const auto &bin = bins[feature];
      for (const std::size_t r : seen)
        sums[leaf[r]][bin[r]].add({slope[r], curvature[r]});
      for (auto &node : sums)
        for (int b = 1; b < n_bins; ++b)
          node[b].add(node[b - 1]);
      return sums;
    }

    /** A cut with a side that is too small to tell is none. */
    void
    improve(Question                      &best,
            const std::array<Sum, n_bins> &sums,
            const int                      feature) const
    {
      const Sum &all = sums.back();
      for (int b = 0; b < int(cuts[feature].size()); ++b)
        {
          const Sum &low = sums[b];
          const Sum  high{all.slope - low.slope, all.curvature - low.curvature};
          if (low.curvature < least_side || high.curvature < least_side)
            continue;
          const double gain = low.gain() + high.gain() - all.gain();
          if (gain > best.gain)
            best = {gain, feature, b};
        }
    }

    const TreeData                        &data;
    const std::size_t                      n_rows;
    std::vector<double>                    odds, slope, curvature;
    std::vector<std::uint8_t>              leaf;
    std::vector<std::size_t>               seen;
    std::vector<std::vector<float>>        cuts;
    std::vector<std::vector<std::uint8_t>> bins;
    cv::RNG                                random;
  };
} // namespace squeal::testing

#endif
