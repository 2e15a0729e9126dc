// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/tribology/images/line_judge.h>
#include <squeal/tribology/images/path_evidence.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace squeal::tribology
{
  namespace
  {
    // Log odds of a place without a line, and what a direction or a place
    // beside the line costs.
    constexpr double no_line = -1., beside_cost = 0.3;
    constexpr double no_neighbour = -6., largest_odds = 6.;
    // A line this long counts in full where another one leads to.
    constexpr double full_length = 20., short_odds = -3.;
    // Log odds of lines that make a part, and pixels of those that join them.
    constexpr double part = -1., loose_part = -2.5;
    constexpr int    longest_joint = 5;

    void
    raise(cv::Mat &plane, const cv::Point &p, const double odds)
    {
      constexpr double unit  = OrientedContrast::per_unit;
      const double     value = std::clamp(
        odds, double(OrientedContrast::least), double(OrientedContrast::most));
      auto &old = plane.at<std::int16_t>(p);
      old       = std::max(old, std::int16_t(std::lround(unit * value)));
    }



    double &
    context_of(std::array<double, n_all_features> &features,
               const ContextFeature                k)
    {
      return features[std::size_t(n_own_features + int(k))];
    }



    /** Edges at each junction. */
    std::vector<std::vector<std::size_t>>
    edges_at(const LineGraph &graph)
    {
      std::vector<std::vector<std::size_t>> result(graph.junctions.size());
      for (std::size_t i = 0; i < graph.edges.size(); ++i)
        for (const int node : graph.edges[i].nodes)
          if (result[node].empty() || result[node].back() != i)
            result[node].push_back(i);
      return result;
    }
  } // namespace



  void
  JudgedLines::add_context(const std::vector<double> &alone)
  {
    std::vector<double> odds;
    for (std::size_t i = 0; i < alone.size(); ++i)
      {
        context_of(features[i], ContextFeature::alone) = alone[i];
        odds.push_back(std::clamp(alone[i], no_neighbour, largest_odds));
      }
    add_paths(alone, 2, ContextFeature::path);
    add_paths(alone, 4, ContextFeature::long_path);
    add_ends(odds);
    add_parts(odds, part, ContextFeature::part_length);
    add_parts(odds, loose_part, ContextFeature::loose_length);
  }



  void
  JudgedLines::add_paths(const std::vector<double> &alone,
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
            const int       t = (direction.at<uchar>(p) + turn + n) % n;
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
        context_of(features[i], feature) = sum / double(cores[i].size());
      }
  }



  void
  JudgedLines::add_ends(const std::vector<double> &odds)
  {
    const auto at    = edges_at(graph);
    const auto reach = [&](const std::size_t j) {
      const double share = std::min(1., double(cores[j].size()) / full_length);
      return share * odds[j] + (1. - share) * short_odds;
    };
    for (std::size_t i = 0; i < odds.size(); ++i)
      {
        const auto           &nodes = graph.edges[i].nodes;
        std::array<double, 2> end{{no_neighbour, no_neighbour}}, far = end;
        for (std::size_t k = 0; k < std::min<std::size_t>(2, nodes.size()); ++k)
          for (const std::size_t j : at[nodes[k]])
            if (j != i)
              {
                end[k] = std::max(end[k], odds[j]);
                far[k] = std::max(far[k], reach(j));
                for (const int other : graph.edges[j].nodes)
                  if (other != nodes[k])
                    for (const std::size_t next : at[other])
                      if (next != i && next != j)
                        far[k] = std::max(far[k], reach(next));
              }
        using C                                  = ContextFeature;
        context_of(features[i], C::weaker_end)   = std::min(end[0], end[1]);
        context_of(features[i], C::better_end)   = std::max(end[0], end[1]);
        context_of(features[i], C::weaker_reach) = std::min(far[0], far[1]);
        context_of(features[i], C::better_reach) = std::max(far[0], far[1]);
      }
  }



  void
  JudgedLines::add_parts(const std::vector<double> &odds,
                         const double               least,
                         const ContextFeature       feature)
  {
    const std::size_t n = odds.size();
    std::vector<char> joined(n);
    for (std::size_t i = 0; i < n; ++i)
      joined[i] = odds[i] >= least || int(cores[i].size()) <= longest_joint;
    const std::vector<int> number = graph.parts(joined);
    std::vector<double>    length(n, 0.), sum(n, 0.);
    for (std::size_t i = 0; i < n; ++i)
      if (odds[i] >= least)
        {
          length[number[i]] += double(cores[i].size());
          sum[number[i]] += double(cores[i].size()) * odds[i];
        }
    const auto mean = ContextFeature(int(feature) + 1);
    for (std::size_t i = 0; i < n; ++i)
      {
        const bool is_in = odds[i] >= least;
        context_of(features[i], feature) =
          is_in ? std::log1p(length[number[i]]) : 0.;
        context_of(features[i], mean) =
          is_in ? sum[number[i]] / length[number[i]] : no_neighbour;
      }
  }
} // namespace squeal::tribology
