// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/tribology/images/line_judge.h>
#include <squeal/tribology/images/path_evidence.h>

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace squeal::tribology
{
  namespace
  {
    constexpr double crest       = 2.; // contrast
    constexpr double core_counts = 2.; // contrast of a core
    constexpr int    crest_spur  = 4;  // pixels
    // Log odds of a place without a line, and what a direction or a place
    // beside the line costs.
    constexpr double no_line = -1., beside_cost = 0.3;
    constexpr double no_neighbour = -3., largest_odds = 3.;

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



    void
    raise(cv::Mat &plane, const cv::Point &p, const double odds)
    {
      constexpr double unit  = OrientedContrast::per_unit;
      const double     value = std::clamp(
        odds, double(OrientedContrast::least), double(OrientedContrast::most));
      auto &old = plane.at<std::int16_t>(p);
      old       = std::max(old, std::int16_t(std::lround(unit * value)));
    }
  } // namespace



  JudgedLines::JudgedLines(const cv::Mat    &grey,
                           const RidgeField &ridges,
                           const LineJudge  &judge)
    : crests(find_crests(ridges))
    , graph(crests)
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
    this->judge(ridges, judge);
  }



  void
  JudgedLines::judge(const RidgeField &ridges, const LineJudge &judge)
  {
    std::vector<double> alone;
    for (const auto &f : features)
      {
        LineFeatures own;
        std::copy(f.begin(), f.begin() + n_line_features, own.begin());
        alone.push_back(judge.alone(own));
      }
    add_context(ridges, alone);
    log_odds.clear();
    for (const auto &f : features)
      log_odds.push_back(judge.in_context(f));
  }



  void
  JudgedLines::add_context(const RidgeField          &ridges,
                           const std::vector<double> &alone)
  {
    for (std::size_t i = 0; i < alone.size(); ++i)
      features[i][n_line_features + int(ContextFeature::alone)] = alone[i];
    add_paths(ridges, alone, 2, ContextFeature::path);
    add_paths(ridges, alone, 4, ContextFeature::long_path);
    add_ends(alone);
  }



  void
  JudgedLines::add_paths(const RidgeField          &ridges,
                         const std::vector<double> &alone,
                         const int                  reduction,
                         const ContextFeature       feature)
  {
    constexpr int    n = OrientedContrast::n_directions;
    OrientedContrast odds;
    const cv::Size   size((crests.cols + reduction - 1) / reduction,
                        (crests.rows + reduction - 1) / reduction);
    for (cv::Mat &plane : odds.planes)
      plane =
        cv::Mat(size, CV_16S, cv::Scalar(no_line * OrientedContrast::per_unit));
    const cv::Rect inside({0, 0}, size);
    for (std::size_t i = 0; i < alone.size(); ++i)
      for (const cv::Point &p : graph.edges[i].piece.pixels)
        for (int turn = -1; turn <= 1; ++turn)
          {
            const int       t = (ridges.direction.at<uchar>(p) + turn + n) % n;
            const cv::Point q(p.x / reduction, p.y / reduction);
            raise(odds.planes[t], q, alone[i] - beside_cost * std::abs(turn));
            for (int k = 0; k < 8; k += 2)
              if (inside.contains(q + neighbour_steps[k]))
                raise(odds.planes[t],
                      q + neighbour_steps[k],
                      alone[i] - beside_cost * (1 + std::abs(turn)));
          }
    const cv::Mat best = integrate_paths(odds).mean;
    for (std::size_t i = 0; i < alone.size(); ++i)
      {
        double sum = 0.;
        for (const cv::Point &p : cores[i])
          sum += best.at<float>(p.y / reduction, p.x / reduction);
        features[i][n_line_features + int(feature)] =
          sum / double(cores[i].size());
      }
  }



  void
  JudgedLines::add_ends(const std::vector<double> &alone)
  {
    // The two best edges at each junction: one may be the edge itself.
    struct Best
    {
      int    edge  = -1;
      double first = no_neighbour, second = no_neighbour;
    };
    std::vector<Best> best(graph.junctions.size());
    for (std::size_t i = 0; i < alone.size(); ++i)
      for (const int node : graph.edges[i].nodes)
        {
          Best &b = best[node];
          if (b.edge < 0 || alone[i] > b.first)
            {
              b.second = b.edge < 0 ? no_neighbour : b.first;
              b.first  = alone[i];
              b.edge   = int(i);
            }
          else
            b.second = std::max(b.second, alone[i]);
        }
    for (std::size_t i = 0; i < alone.size(); ++i)
      {
        std::array<double, 2> ends{{no_neighbour, no_neighbour}};
        const auto           &nodes = graph.edges[i].nodes;
        for (std::size_t k = 0; k < std::min<std::size_t>(2, nodes.size()); ++k)
          {
            const Best &b = best[nodes[k]];
            ends[k]       = std::clamp(b.edge == int(i) ? b.second : b.first,
                                 no_neighbour,
                                 largest_odds);
          }
        const auto [low, high] = std::minmax(ends[0], ends[1]);
        features[i][n_line_features + int(ContextFeature::weaker_end)] = low;
        features[i][n_line_features + int(ContextFeature::better_end)] = high;
      }
  }
} // namespace squeal::tribology
