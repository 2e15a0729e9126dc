// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_images_line_judge_h
#define squeal_tribology_images_line_judge_h

#include <squeal/tribology/images/line_features.h>
#include <squeal/tribology/images/line_graph.h>

#include <array>
#include <vector>

namespace squeal::tribology
{
  /** What the lines around say of a line: log odds. */
  enum class ContextFeature
  {
    alone,      /**< its own, by its features alone */
    path,       /**< best path of 72 pixels through judged lines */
    long_path,  /**< the same, 144 pixels */
    weaker_end, /**< best line that begins where it ends, the lesser end */
    better_end  /**< the other end */
  };
  constexpr int n_context_features = int(ContextFeature::better_end) + 1;

  /** Logistic regression: the log odds of a line being part of a crack are
   * offset + sum of weight (feature - mean) / deviation, each quotient limited
   * to +-3. */
  template <int n>
  struct LogOdds
  {
    double                offset = 0.;
    std::array<double, n> mean{}, deviation{}, weight{};

    double
    operator()(const std::array<double, n> &features) const
    {
      double sum = offset;
      for (int k = 0; k < n; ++k)
        {
          const double u = (features[k] - mean[k]) / deviation[k];
          sum += weight[k] * (u < -3. ? -3. : u > 3. ? 3. : u);
        }
      return sum;
    }
  };

  constexpr int n_all_features = n_line_features + n_context_features;

  /** Two judgements: by its own features, then among its neighbours. The
   * numbers of standard() are in line_judge_table.cc, which
   * tests/tribology/train_line_judge.cc writes from images with masks. */
  struct LineJudge
  {
    LogOdds<n_line_features> alone;
    LogOdds<n_all_features>  in_context;

    static const LineJudge &standard();
  };

  /** The crests of an image as lines between junctions, measured and judged. */
  class JudgedLines
  {
  public:
    JudgedLines(const cv::Mat    &grey,
                const RidgeField &ridges,
                const LineJudge  &judge);

    /** Judges them anew. */
    void judge(const RidgeField &ridges, const LineJudge &judge);

    /** Features of each edge, in its context. */
    std::vector<std::array<double, n_all_features>> features;
    std::vector<double>    log_odds; /**< of each edge */
    std::vector<PixelPath> cores;    /**< of each edge, without hooks */
    cv::Mat                crests;   /**< CV_8U, skeleton */
    LineGraph              graph;
    cv::Mat1f              darkness; /**< LineMeter::darkness() */

  private:
    void add_context(const RidgeField          &ridges,
                     const std::vector<double> &alone);
    void add_paths(const RidgeField          &ridges,
                   const std::vector<double> &alone,
                   int                        reduction,
                   ContextFeature             feature);
    void add_ends(const std::vector<double> &alone);
  };
} // namespace squeal::tribology

#endif
