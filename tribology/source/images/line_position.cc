// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/tribology/images/line_graph.h>
#include <squeal/tribology/images/line_position.h>
#include <squeal/tribology/images/line_smoothing.h>

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace squeal::tribology
{
  namespace
  {
    // In pixels.
    constexpr double image_deviation = 1.2;
    constexpr double curve_deviation = 1.5; // along the line
    constexpr double step_across     = 0.5;
    constexpr double flank_reach     = 5.;
    constexpr int    tangent         = 2; // to each side
    constexpr int    shortest_edge   = 6;
    // In steps across.
    constexpr int n_across      = 5; // to each side
    constexpr int largest_shift = 2; // from pixel to pixel
    // The second round goes across the line that the first one found.
    constexpr int n_position_rounds = 2;
    // In depths of the line, for a shift by a pixel.
    constexpr double shift_cost = 0.1;

    Curve
    smoothed_axis(const Curve &curve)
    {
      const int reach = int(std::ceil(3. * curve_deviation));
      return averaged_along(curve, false, mean_weights(curve_deviation, reach));
    }



    /** Unit vectors across the curve. */
    Curve
    normals(const Curve &curve)
    {
      const int n = int(curve.size());
      Curve     result;
      for (int i = 0; i < n; ++i)
        {
          const cv::Point2d d = curve[std::min(n - 1, i + tangent)] -
                                curve[std::max(0, i - tangent)];
          result.push_back(cv::Point2d(-d.y, d.x) *
                           (1. / std::max(1e-9, cv::norm(d))));
        }
      return result;
    }



    /** Values beside each point of the curve, a row each, at @p offsets. */
    cv::Mat1f
    values_across(const cv::Mat             &image,
                  const Curve               &curve,
                  const Curve               &normal,
                  const std::vector<double> &offsets)
    {
      cv::Mat1f x(int(curve.size()), int(offsets.size())), y(x.size()), values;
      for (int i = 0; i < x.rows; ++i)
        for (int k = 0; k < x.cols; ++k)
          {
            const cv::Point2d p = curve[i] + offsets[k] * normal[i];
            x(i, k)             = float(p.x);
            y(i, k)             = float(p.y);
          }
      cv::remap(image, values, x, y, cv::INTER_LINEAR, cv::BORDER_REPLICATE);
      return values;
    }



    /** Brightness beside each point of the curve, over the mean depth of the
     * dark line below the darker flank. */
    cv::Mat1f
    brightness_across(const cv::Mat &smooth,
                      const Curve   &curve,
                      const Curve   &normal)
    {
      std::vector<double> offsets;
      for (int k = -n_across; k <= n_across; ++k)
        offsets.push_back(k * step_across);
      const cv::Mat1f values = values_across(smooth, curve, normal, offsets);
      const cv::Mat1f flanks =
        values_across(smooth, curve, normal, {-flank_reach, flank_reach});
      cv::Mat1f darkest, beside;
      cv::reduce(values, darkest, 1, cv::REDUCE_MIN);
      cv::reduce(flanks, beside, 1, cv::REDUCE_MIN);
      const cv::Mat depth = cv::max(beside - darkest, 1.);
      return values / cv::mean(depth)[0];
    }



    /** The column of each row on the cheapest way down. */
    std::vector<int>
    cheapest_way(const cv::Mat1f &cost)
    {
      cv::Mat1d sums = cost;
      cv::Mat1i from(cost.size(), 0);
      for (int i = 1; i < cost.rows; ++i)
        for (int k = 0; k < cost.cols; ++k)
          {
            double    least = 1e30;
            const int first = std::max(0, k - largest_shift);
            const int last  = std::min(cost.cols - 1, k + largest_shift);
            for (int j = first; j <= last; ++j)
              {
                const double d   = (k - j) * step_across;
                const double sum = sums(i - 1, j) + shift_cost * d * d;
                if (sum < least)
                  {
                    least      = sum;
                    from(i, k) = j;
                  }
              }
            sums(i, k) += least;
          }
      std::vector<int> way(cost.rows);
      const double    *last = sums[cost.rows - 1];
      int              k = int(std::min_element(last, last + cost.cols) - last);
      for (int i = cost.rows - 1; i >= 0; --i)
        {
          way[i] = k;
          k      = from(i, k);
        }
      return way;
    }



    Curve
    moved(const cv::Mat &smooth, const PixelPath &axis)
    {
      Curve curve = smoothed_axis(Curve(axis.begin(), axis.end()));
      if (int(curve.size()) < shortest_edge)
        return curve;
      for (int round = 0; round < n_position_rounds; ++round)
        {
          const Curve            normal = normals(curve);
          const std::vector<int> way =
            cheapest_way(brightness_across(smooth, curve, normal));
          for (std::size_t i = 0; i < curve.size(); ++i)
            curve[i] += (way[i] - n_across) * step_across * normal[i];
          curve = smoothed_axis(curve);
        }
      return curve;
    }



    /** The axis of a ring is half of it. */
    bool
    is_ring(const LinePiece &piece)
    {
      return 3 * piece.pixels.size() > 4 * piece.axis.size();
    }



    void
    draw(cv::Mat &image, const cv::Point2d &a, const cv::Point2d &b)
    {
      cv::line(image, a, b, 255);
    }



    /** A junction moves with the ends of the edges that meet in it. */
    class Junctions
    {
    public:
      explicit Junctions(const LineGraph &graph)
        : graph(graph)
        , nodes(graph.junctions.size())
      {
      }

      /** The end pixel of @p edge at @p from went @p to there. */
      void
      move_end(const LineGraph::Edge &edge,
               const cv::Point       &from,
               const cv::Point2d     &to)
      {
        for (const int node : edge.nodes)
          for (const cv::Point &q : graph.junctions[node])
            if (std::abs(q.x - from.x) <= 1 && std::abs(q.y - from.y) <= 1)
              {
                nodes[node].shift += to - cv::Point2d(from);
                nodes[node].ends.push_back(to);
                return;
              }
      }

      /** Draws a star from each to the ends that meet there. */
      void
      draw_on(cv::Mat &image) const
      {
        for (std::size_t i = 0; i < nodes.size(); ++i)
          {
            cv::Point2d place(0., 0.);
            for (const cv::Point &p : graph.junctions[i])
              place += cv::Point2d(p) * (1. / graph.junctions[i].size());
            for (const cv::Point2d &end : nodes[i].ends)
              draw(image,
                   end,
                   place + nodes[i].shift * (1. / nodes[i].ends.size()));
          }
      }

    private:
      struct Node
      {
        cv::Point2d shift{0., 0.}; /**< sum over its ends */
        Curve       ends;
      };

      const LineGraph  &graph;
      std::vector<Node> nodes;
    };
  } // namespace



  cv::Mat
  move_to_middle(const cv::Mat &grey, const cv::Mat &centre_line)
  {
    cv::Mat smooth;
    cv::GaussianBlur(grey, smooth, cv::Size(), image_deviation);
    const LineGraph graph(centre_line);
    Junctions       junctions(graph);
    cv::Mat         result = cv::Mat::zeros(centre_line.size(), CV_8U);
    for (const LineGraph::Edge &edge : graph.edges)
      {
        const PixelPath &axis = edge.piece.axis;
        if (is_ring(edge.piece))
          {
            for (const cv::Point &p : edge.piece.pixels)
              result.at<uchar>(p) = 255;
            continue;
          }
        const Curve curve = moved(smooth, axis);
        draw(result, curve[0], curve[0]);
        for (std::size_t i = 1; i < curve.size(); ++i)
          draw(result, curve[i - 1], curve[i]);
        junctions.move_end(edge, axis.front(), curve.front());
        junctions.move_end(edge, axis.back(), curve.back());
      }
    junctions.draw_on(result);
    return thin(result);
  }
} // namespace squeal::tribology
