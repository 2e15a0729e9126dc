// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/tribology/images/line_judge.h>

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <locale>
#include <numeric>
#include <sstream>
#include <type_traits>

namespace squeal::tribology
{
  namespace
  {
    constexpr double crest       = 2.; // contrast
    constexpr double core_counts = 2.; // contrast of a core
    constexpr int    crest_spur  = 4;  // pixels
    constexpr int    long_line   = 12; // pixels, of those to compare with
    constexpr int    n_longer    = 3;  // of them
    constexpr double least_share = 1e-4;

    cv::Mat
    find_crests(const RidgeField &ridges)
    {
      cv::Mat crests = cv::Mat::zeros(ridges.sharp.size(), CV_8U);
      for (int y = 0; y < crests.rows; ++y)
        {
          const float *z = ridges.sharp.ptr<float>(y);
          for (int x = 0; x < crests.cols; ++x)
            if (z[x] >= crest && ridges.is_crest({x, y}))
              crests.at<uchar>(y, x) = 255;
        }
      cv::dilate(crests, crests, cv::Mat());
      cv::Mat skeleton = thin(crests);
      remove_spurs(skeleton, crest_spur);
      return skeleton;
    }



    /** The pixels of an edge between the first and the last of contrast: crests
     * go on beyond a crack by a hook. An edge that is hooks for the most part
     * stays as it is. */
    PixelPath
    core_of(const RidgeField &ridges, const PixelPath &axis)
    {
      const auto has_contrast = [&](const cv::Point &p) {
        return ridges.local.at<float>(p) >= core_counts;
      };
      const auto first = std::find_if(axis.begin(), axis.end(), has_contrast);
      const auto last =
        std::find_if(axis.rbegin(), axis.rend(), has_contrast).base();
      return last - first >= 0.5 * axis.size() ? PixelPath(first, last) : axis;
    }



    /** The median of @p values, each as often as it has pixels. */
    double
    median_by_length(const std::vector<double> &values,
                     const std::vector<double> &lengths)
    {
      std::vector<std::size_t> order(values.size());
      std::iota(order.begin(), order.end(), std::size_t(0));
      std::sort(order.begin(), order.end(), [&](const auto a, const auto b) {
        return values[a] < values[b];
      });
      double sum = 0.;
      for (const double n : lengths)
        sum += 0.5 * n;
      for (const std::size_t i : order)
        if ((sum -= lengths[i]) <= 0.)
          return values[i];
      return 0.;
    }



    /** The third largest of the long lines, or what comes next to it: a crack
     * is often two lines. */
    double
    usual_largest(const std::vector<double> &values,
                  const std::vector<double> &lengths)
    {
      std::vector<double> longer;
      for (std::size_t i = 0; i < values.size(); ++i)
        if (lengths[i] >= long_line)
          longer.push_back(values[i]);
      if (longer.empty())
        return *std::max_element(values.begin(), values.end());
      std::sort(longer.begin(), longer.end(), std::greater<>());
      return longer[std::min<std::size_t>(n_longer, longer.size()) - 1];
    }



    BoostedTrees
    parsed(const char *text)
    {
      BoostedTrees       result;
      std::istringstream in(text);
      in.imbue(std::locale::classic());
      in >> result.offset;
      const auto read_all = [&](auto &values) {
        for (auto &value : values)
          {
            double number = 0.;
            in >> number;
            value = std::remove_reference_t<decltype(value)>(number);
          }
      };
      for (BoostedTrees::Tree tree; in; result.trees.push_back(tree))
        {
          read_all(tree.feature);
          read_all(tree.cut);
          read_all(tree.leaf);
          if (!in)
            break;
        }
      return result;
    }
  } // namespace



  LineJudge::LineJudge(const char *alone,
                       const char *in_context,
                       const char *typical)
    : alone(parsed(alone))
    , in_context(parsed(in_context))
  {
    std::istringstream in(typical);
    in.imbue(std::locale::classic());
    for (double &value : this->typical)
      in >> value;
  }



  JudgedLines::JudgedLines(const cv::Mat &grey, const RidgeField &ridges)
    : crests(find_crests(ridges))
    , graph(crests)
    , direction(ridges.direction)
  {
    const LineMeter meter(grey, ridges, crests);
    for (const LineGraph::Edge &edge : graph.edges)
      {
        cores.push_back(core_of(ridges, edge.piece.axis));
        const LineFeatures own = meter.measure(edge.piece, cores.back());
        features.emplace_back();
        std::copy(own.begin(), own.end(), features.back().begin());
      }
    darkness = meter.darkness();
    if (!features.empty())
      compare();
  }



  void
  JudgedLines::compare()
  {
    const std::size_t   n = features.size();
    std::vector<double> lengths, values(n);
    double              all = 0.;
    for (const PixelPath &core : cores)
      {
        lengths.push_back(double(core.size()));
        all += lengths.back();
      }
    std::size_t to = n_line_features;
    for (const LineFeature k : compared_features)
      {
        for (std::size_t i = 0; i < n; ++i)
          values[i] = features[i][std::size_t(k)];
        const double middle  = median_by_length(values, lengths);
        const double largest = usual_largest(values, lengths);
        for (std::size_t i = 0; i < n; ++i)
          {
            features[i][to]     = values[i] - middle;
            features[i][to + 1] = values[i] - largest;
          }
        to += 2;
      }
    const double share = all / double(crests.total());
    for (std::size_t i = 0; i < n; ++i)
      {
        const double contrast = features[i][std::size_t(LineFeature::contrast)];
        features[i][to]       = std::log1p(lengths[i] * std::max(0., contrast));
        features[i][to + 1]   = std::log(share + least_share);
      }
  }



  std::vector<double>
  JudgedLines::odds_alone(const BoostedTrees &trees) const
  {
    std::vector<double> odds;
    for (const auto &f : features)
      odds.push_back(trees(f));
    return odds;
  }



  void
  JudgedLines::judge(const LineJudge &judge)
  {
    add_context(odds_alone(judge.alone));
    log_odds.clear();
    for (const auto &f : features)
      log_odds.push_back(judge.in_context(f));
  }
} // namespace squeal::tribology
