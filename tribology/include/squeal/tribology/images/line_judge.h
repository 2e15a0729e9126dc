// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_images_line_judge_h
#define squeal_tribology_images_line_judge_h

#include <squeal/tribology/images/boosted_trees.h>
#include <squeal/tribology/images/line_features.h>
#include <squeal/tribology/images/line_graph.h>

#include <array>
#include <vector>

namespace squeal::tribology
{
  /** Features that are compared with those of the other lines of the image: a
   * contrast that is usual on one surface is none on another. */
  constexpr std::array<LineFeature, 10> compared_features = {
    {LineFeature::contrast,
     LineFeature::path,
     LineFeature::coarse_path,
     LineFeature::peak_contrast,
     LineFeature::weak_contrast,
     LineFeature::darkness,
     LineFeature::straight_run,
     LineFeature::clutter,
     LineFeature::depth_in_texture,
     LineFeature::depth}};

  /** What a line is among all of its image. First, for each of the compared
   * features, its excess over the median by length, and over the third of the
   * lines of 12 pixels or more; then the last two. */
  enum class ComparedFeature
  {
    compared     = 0,
    sum_contrast = 2 * int(compared_features.size()), /**< logarithm of 1 +
                                                           length * contrast */
    n_lines /**< logarithm of the share of pixels on lines */
  };
  constexpr int n_compared_features = int(ComparedFeature::n_lines) + 1;

  /** What a line is by itself and among all of its image. */
  constexpr int n_own_features = n_line_features + n_compared_features;

  /** What the lines around say of a line. Log odds are limited to +-6, lengths
   * are logarithms of 1 + pixels. */
  enum class ContextFeature
  {
    alone,        /**< its own log odds, without a context */
    path,         /**< best path of 72 pixels through judged lines */
    long_path,    /**< the same, 144 pixels */
    weaker_end,   /**< best line that begins where it ends, the lesser end */
    better_end,   /**< the other end */
    weaker_reach, /**< the same among the next two lines, short ones less */
    better_reach,
    part_length,  /**< of the connected lines of log odds -1 or more; 0 if it is
                       none of them */
    part_odds,    /**< their mean log odds */
    loose_length, /**< the same, -2.5 or more */
    loose_odds
  };
  constexpr int n_context_features = int(ContextFeature::loose_odds) + 1;
  constexpr int n_all_features     = n_own_features + n_context_features;

  /** Two judgements: by a line's own features, then among its neighbours. The
   * numbers of standard() are in line_judge_table.cc, which
   * tests/tribology/train_line_judge.cc writes from images with masks. */
  struct LineJudge
  {
    LineJudge() = default;

    /** From texts of numbers: log odds without any tree, then the features,
     * cuts and leaves of each tree; the typical features. */
    LineJudge(const char *alone, const char *in_context, const char *typical);

    BoostedTrees alone;      /**< of n_own_features */
    BoostedTrees in_context; /**< of n_all_features */
    /** Mean features of lines that are cracks. */
    std::array<double, n_all_features> typical{};

    static const LineJudge &standard();
  };

  /** The crests of an image as lines between junctions, measured and judged. */
  class JudgedLines
  {
  public:
    /** Measures the lines, and judges none. */
    JudgedLines(const cv::Mat &grey, const RidgeField &ridges);

    void judge(const LineJudge &judge);

    /** Log odds of each edge without its context. */
    std::vector<double> odds_alone(const BoostedTrees &trees) const;

    /** Fills in the features of the context from such log odds. */
    void add_context(const std::vector<double> &alone);

    /** Features of each edge, in its context. */
    std::vector<std::array<double, n_all_features>> features;
    std::vector<double>    log_odds; /**< of each edge, once judged */
    std::vector<PixelPath> cores;    /**< of each edge, without hooks */
    cv::Mat                crests;   /**< CV_8U, skeleton */
    LineGraph              graph;
    cv::Mat1f              darkness; /**< LineMeter::darkness() */

  private:
    void compare();
    void add_paths(const std::vector<double> &alone,
                   int                        reduction,
                   ContextFeature             feature);
    void add_ends(const std::vector<double> &alone);
    void add_parts(const std::vector<double> &alone,
                   double                     least,
                   ContextFeature             feature);

    cv::Mat direction; /**< RidgeField::direction */
  };
} // namespace squeal::tribology

#endif
