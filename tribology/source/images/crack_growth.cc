// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/tribology/images/crack_growth.h>

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <queue>
#include <utility>
#include <vector>

namespace squeal::tribology
{
  namespace
  {
    constexpr double half_sector       = 0.5; // cosine
    constexpr double least_strength    = 2.;
    constexpr double crest_strength    = 2.;
    constexpr double faint_strength    = 2.4;
    constexpr double faint_mean_coarse = 2.;
    constexpr double end_strength      = 2.8;  // contrast that adds up to
    constexpr double end_sum           = 2.;   // at least this
    constexpr double straight_within   = 0.45; // pixels
    constexpr double least_share       = 0.2;  // of the darkness of the crack
    constexpr int    n_trials          = 400;
    constexpr int    n_rounds          = 12;
    constexpr double n_deviations      = 3.;
    constexpr double one_below = 0.1587; // quantile of a deviation below
    // Of the place of an end, in pixels.
    constexpr int shortest_behind = 10; // of the line that is looked at
    constexpr int farthest_in = 6, farthest_out = 4;
    constexpr int seen_through = 6; // from the border of the image
    // A crack is narrower, so less dark, at its tip.
    constexpr double darkness_of_tip = 1. / 3.;

    /** Near the tip of a line, or within the sector in front of it. */
    bool
    is_ahead(const cv::Point2d &from_tip, const cv::Point2d &ahead)
    {
      const double length = cv::norm(from_tip);
      return length <= 2.5 || from_tip.dot(ahead) >= half_sector * length;
    }

    /** A groove that the crack meets. */
    bool
    is_straight(const PixelPath &way)
    {
      LinePiece piece;
      piece.axis = way;
      return way.size() > 20 && piece.waviness() < straight_within;
    }

    /** Ways of the smallest sum of costs from one pixel to others of a window,
     * by Dijkstra: half of the time of a segmentation is spent here. */
    class CheapestWays
    {
    public:
      explicit CheapestWays(const cv::Mat1f &window)
        : stride(window.cols + 2)
        , sums((window.rows + 2) * stride, blocked)
        , from(sums.size())
      {
        // A frame that no way leads to, so that nobody asks for the border.
        for (int y = 0; y < window.rows; ++y)
          std::fill_n(&sums[index({0, y})], window.cols, 1e9F);
        cv::copyMakeBorder(window, padded, 1, 1, 1, 1, cv::BORDER_CONSTANT, 1.);
        costs = padded.ptr<float>();
        for (int k = 0; k < 8; ++k)
          steps[k] = neighbour_steps[k].y * stride + neighbour_steps[k].x;
      }

      void
      begin(const cv::Point &start)
      {
        reach(index(start), 0.F, 0);
      }

      /** The nearest pixel that was not given yet; false: there is none. */
      bool
      next(cv::Point &u)
      {
        while (!queue.empty())
          {
            const auto [sum, at] = entry(queue.top());
            queue.pop();
            if (sum > sums[at])
              continue;
            u = {at % stride - 1, at / stride - 1};
            return true;
          }
        return false;
      }

      /** Reaches the neighbours of @p u that are @p allowed. */
      template <typename Allowed>
      void
      go_on(const cv::Point &u, const Allowed &allowed)
      {
        const int   at  = index(u);
        const float sum = sums[at];
        for (int k = 0; k < 8; ++k)
          {
            const int v = at + steps[k];
            // Most neighbours are reached already, which is told sooner than
            // where they lie.
            const float further = sum + costs[v] * (k % 2 == 1 ? 1.4142F : 1.F);
            if (!(further < sums[v]))
              continue;
            if (allowed(u + neighbour_steps[k]))
              reach(v, further, k);
            else
              sums[v] = blocked;
          }
      }

      /** The last step of the way to @p u. */
      const cv::Point &
      step_to(const cv::Point &u) const
      {
        return neighbour_steps[from[index(u)]];
      }

    private:
      /** Below all sums, so that no way is shorter. */
      static constexpr float blocked = -1.F;

      int
      index(const cv::Point &u) const
      {
        return (u.y + 1) * stride + u.x + 1;
      }

      /** Floats that are not negative have the order of their bits: a sum and
       * the pixel that it leads to are one number, in that order. */
      void
      reach(const int at, const float sum, const int step)
      {
        sums[at] = sum;
        from[at] = uchar(step);
        std::uint32_t bits;
        std::memcpy(&bits, &sum, sizeof(bits));
        queue.push(std::uint64_t(bits) << 32U | std::uint32_t(at));
      }

      static std::pair<float, int>
      entry(const std::uint64_t key)
      {
        const auto bits = std::uint32_t(key >> 32U);
        float      sum;
        std::memcpy(&sum, &bits, sizeof(sum));
        return {sum, int(std::uint32_t(key))};
      }

      const int          stride;
      std::vector<float> sums;
      std::vector<uchar> from; /**< the step that led here */
      cv::Mat1f          padded;
      const float       *costs = nullptr;
      std::array<int, 8> steps;
      std::priority_queue<std::uint64_t,
                          std::vector<std::uint64_t>,
                          std::greater<>>
        queue;
    };
  } // namespace



  CrackGrowth::CrackGrowth(const RidgeField &ridges,
                           const cv::Mat    &contrast,
                           const cv::Mat1f  &darkness,
                           const cv::Mat    &centre_line,
                           const double      reach)
    : ridges(ridges)
    , contrast(contrast)
    , darkness(darkness)
    , reach(reach)
  {
    cv::max(contrast, 0., cost);
    cost += 0.3;
    cv::divide(1., cost, cost);
    calibrate(centre_line);
  }



  void
  CrackGrowth::calibrate(const cv::Mat &centre_line)
  {
    threshold = least_strength;
    if (std::min(cost.cols, cost.rows) < 20)
      return;
    cv::Mat distance;
    cv::distanceTransform(~centre_line, distance, cv::DIST_L2, 3);
    const cv::Mat       nothing = cv::Mat::zeros(cost.size(), CV_8U);
    std::vector<double> found;
    // The same places in every run.
    cv::RNG random(1);
    for (int i = 0; i < 500 * n_trials && int(found.size()) < n_trials; ++i)
      {
        const cv::Point p(random.uniform(8, cost.cols - 8),
                          random.uniform(8, cost.rows - 8));
        const int       sign = random.uniform(0, 2) == 0 ? -1 : 1;
        if (contrast.at<float>(p) < crest_strength ||
            distance.at<float>(p) < reach || !ridges.is_crest(p))
          continue;
        const double    a = ridges.angle(p);
        const Extension e =
          extend({p, {sign * std::cos(a), sign * std::sin(a)}, {}}, nothing);
        if (e.is_full)
          found.push_back(e.mean_strength);
      }
    if (found.size() < 20)
      return;
    std::sort(found.begin(), found.end());
    const double middle = found[found.size() / 2];
    const double below  = found[std::size_t(one_below * double(found.size()))];
    threshold =
      std::max(least_strength, middle + n_deviations * (middle - below));
  }



  double
  CrackGrowth::mean_darkness(const PixelPath &pixels) const
  {
    double sum = 0.;
    for (const cv::Point &p : pixels)
      sum += darkness(p);
    return sum / std::max<std::size_t>(1, pixels.size());
  }



  CrackGrowth::Extension
  CrackGrowth::extend(const LineEnd &end, const cv::Mat &network) const
  {
    const int      radius = int(std::ceil(reach)) + 1;
    const cv::Rect window = cv::Rect(end.tip.x - radius,
                                     end.tip.y - radius,
                                     2 * radius + 1,
                                     2 * radius + 1) &
                            cv::Rect({0, 0}, cost.size());
    CheapestWays    ways(cost(window));
    const cv::Point start = end.tip - window.tl();
    cv::Point       last(-1, -1);
    Extension       extension;
    ways.begin(start);
    for (cv::Point u; ways.next(u);)
      {
        const cv::Point p        = u + window.tl();
        const double    distance = cv::norm(p - end.tip);
        const int       to_edge =
          std::min({p.x, p.y, cost.cols - 1 - p.x, cost.rows - 1 - p.y});
        extension.is_full = distance >= reach - 0.7;
        if (extension.is_full || (distance > 6. && to_edge < 2) ||
            (distance > 3. && network.at<uchar>(p) != 0))
          {
            last = u;
            break;
          }
        ways.go_on(u, [&](const cv::Point &v) {
          return is_ahead(v - start, end.ahead);
        });
      }
    if (last.x < 0)
      return extension;
    double strength = 0., coarse = 0.;
    for (cv::Point u = last; u != start; u -= ways.step_to(u))
      {
        const cv::Point p = u + window.tl();
        extension.way.push_back(p);
        strength += contrast.at<float>(p);
        coarse += ridges.coarse.at<float>(p);
      }
    extension.mean_strength = strength / extension.way.size();
    extension.mean_coarse   = coarse / extension.way.size();
    return extension;
  }



  cv::Mat
  CrackGrowth::finish_ends(const cv::Mat &before) const
  {
    cv::Mat network = before.clone();
    for (const LineEnd &end : line_ends(before))
      {
        const PixelPath way = extend(end, before).way;
        double          sum = 0., best = end_sum;
        std::size_t     n = 0;
        // The way is listed from its far end.
        for (std::size_t i = way.size(); i-- > 0;)
          {
            sum += contrast.at<float>(way[i]) - end_strength;
            if (sum > best)
              {
                best = sum;
                n    = way.size() - i;
              }
          }
        for (std::size_t i = way.size() - n; i < way.size(); ++i)
          network.at<uchar>(way[i]) = 255;
      }
    return thin(network);
  }



  cv::Mat
  CrackGrowth::place_ends(const cv::Mat &before) const
  {
    cv::Mat network = before.clone();
    for (const LineEnd &end : line_ends(before))
      {
        const int n_behind = int(end.behind.size());
        if (n_behind < shortest_behind)
          continue;
        const auto   inside = end.behind.begin() + farthest_in;
        const double level =
          darkness_of_tip * mean_darkness(PixelPath(inside, end.behind.end()));
        // From the inside out; the way is listed from its far end.
        PixelPath path(std::make_reverse_iterator(inside), end.behind.rend());
        const PixelPath way   = extend(end, before).way;
        const int       n_out = std::min(farthest_out, int(way.size()));
        path.insert(path.end(), way.rbegin(), way.rbegin() + n_out);
        double sum = 0., best = 0.;
        int    n = 0;
        for (int i = 0; i < int(path.size()); ++i)
          {
            sum += darkness(path[i]) - level;
            if (sum > best)
              {
                best = sum;
                n    = i + 1;
              }
          }
        // A crack that goes on beyond the image has no end there.
        const cv::Rect image({0, 0}, before.size());
        const cv::Rect middle(seen_through,
                              seen_through,
                              image.width - 2 * seen_through,
                              image.height - 2 * seen_through);
        if (!middle.contains(end.tip))
          n = std::max(n, farthest_in);
        for (int i = 0; i < int(path.size()); ++i)
          if (i < farthest_in ? i >= n : i < n)
            network.at<uchar>(path[i]) = i < n ? 255 : 0;
      }
    return thin(network);
  }



  cv::Mat
  CrackGrowth::grow(const cv::Mat &centre_line) const
  {
    cv::Mat network = centre_line.clone();
    for (int round = 0; round < n_rounds; ++round)
      {
        const cv::Mat before = network.clone();
        bool          grown  = false;
        for (const LineEnd &end : line_ends(before))
          {
            const Extension e         = extend(end, before);
            const bool is_faint_crack = e.mean_strength >= faint_strength &&
                                        e.mean_coarse >= faint_mean_coarse;
            if (e.way.empty() || is_straight(e.way) ||
                mean_darkness(e.way) <
                  least_share * mean_darkness(end.behind) ||
                (e.mean_strength < threshold && !is_faint_crack))
              continue;
            for (const cv::Point &p : e.way)
              network.at<uchar>(p) = 255;
            grown = true;
          }
        if (!grown)
          break;
        network = thin(network);
      }
    return network;
  }
} // namespace squeal::tribology
