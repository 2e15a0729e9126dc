// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/tribology/images/line_graph.h>

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace squeal::tribology
{
  namespace
  {
    constexpr int    longest_gap   = 8;    // pixels
    constexpr double line_distance = 0.65; // pixels, root mean square

    /** Least-squares line through points. */
    struct StraightLine
    {
      explicit StraightLine(const PixelPath &points)
      {
        for (const cv::Point2d p : points)
          centre += p * (1. / points.size());
        double xx = 0., yy = 0., xy = 0.;
        for (const cv::Point2d p : points)
          {
            const cv::Point2d d = p - centre;
            xx += d.x * d.x;
            yy += d.y * d.y;
            xy += d.x * d.y;
          }
        const double a      = 0.5 * std::atan2(2. * xy, xx - yy);
        direction           = {std::cos(a), std::sin(a)};
        const double spread = std::hypot(xx - yy, 2. * xy);
        distance =
          std::sqrt(std::max(0., 0.5 * (xx + yy - spread)) / points.size());
      }

      double
      along(const cv::Point2d &p) const
      {
        return (p - centre).dot(direction);
      }

      cv::Point2d centre{0., 0.}, direction;
      double      distance; /**< root mean square */
    };



    /** The pixel that is set next to @p p, if any. */
    bool
    snap(const cv::Mat &skeleton, cv::Point &p)
    {
      const cv::Rect inside({0, 0}, skeleton.size());
      if (inside.contains(p) && skeleton.at<uchar>(p) != 0)
        return true;
      for (const cv::Point &step : neighbour_steps)
        if (inside.contains(p + step) && skeleton.at<uchar>(p + step) != 0)
          {
            p += step;
            return true;
          }
      return false;
    }



    /** Adds the pixels beyond one end of a line; the line is fitted again as
     * it grows. */
    void
    follow(const cv::Mat &skeleton, const int side, PixelPath &points)
    {
      StraightLine line(points);
      double       end = 0.;
      for (const cv::Point &p : points)
        end = std::max(end, side * line.along(p));
      int gap = 0, n_new = 0;
      for (double t = end + 1.; gap <= longest_gap; t += 1.)
        {
          const cv::Point2d q = line.centre + side * t * line.direction;
          cv::Point         p(cvRound(q.x), cvRound(q.y));
          if (!snap(skeleton, p))
            {
              ++gap;
              continue;
            }
          gap = 0;
          points.push_back(p);
          if (++n_new % 10 == 0)
            {
              const StraightLine fitted(points);
              if (fitted.direction.dot(line.direction) < 0.)
                return;
              t    = side * fitted.along(q);
              line = fitted;
              if (line.distance > line_distance)
                return;
            }
        }
    }
  } // namespace



  StraightRun
  straight_run_of(const cv::Mat &skeleton, const LinePiece &piece)
  {
    PixelPath points = piece.axis;
    if (points.size() < 8 || StraightLine(points).distance > line_distance)
      return {};
    follow(skeleton, 1, points);
    follow(skeleton, -1, points);
    const StraightLine line(points);
    if (line.distance > line_distance)
      return {};
    double first = 0., last = 0.;
    for (const cv::Point &p : points)
      {
        first = std::min(first, line.along(p));
        last  = std::max(last, line.along(p));
      }
    return {last - first,
            line.centre + first * line.direction,
            line.centre + last * line.direction};
  }



  LineGraph::LineGraph(const cv::Mat &skeleton)
    : size(skeleton.size())
  {
    cv::Mat   nodes = cv::Mat::zeros(size, CV_8U);
    PixelPath pixels;
    cv::findNonZero(skeleton, pixels);
    for (const cv::Point &p : pixels)
      if (n_neighbours(skeleton, p) > 2)
        nodes.at<uchar>(p) = 255;
    cv::dilate(nodes, nodes, cv::Mat());
    nodes &= skeleton;
    cv::Mat1i labels;
    junctions.resize(cv::connectedComponents(nodes, labels, 8) - 1);
    cv::Mat stretches = skeleton.clone();
    for (const cv::Point &p : pixels)
      if (labels(p) > 0)
        {
          junctions[labels(p) - 1].push_back(p);
          stretches.at<uchar>(p) = 0;
        }
    const cv::Rect inside({0, 0}, size);
    for (LinePiece &piece : line_pieces(stretches))
      {
        Edge edge;
        for (const cv::Point &end : {piece.axis.front(), piece.axis.back()})
          for (const cv::Point &step : neighbour_steps)
            if (inside.contains(end + step) && labels(end + step) > 0)
              edge.nodes.push_back(labels(end + step) - 1);
        std::sort(edge.nodes.begin(), edge.nodes.end());
        edge.nodes.erase(std::unique(edge.nodes.begin(), edge.nodes.end()),
                         edge.nodes.end());
        edge.piece = std::move(piece);
        edges.push_back(std::move(edge));
      }
  }



  cv::Mat
  LineGraph::draw(const std::vector<char> &kept) const
  {
    cv::Mat          result = cv::Mat::zeros(size, CV_8U);
    std::vector<int> n_kept(junctions.size(), 0);
    for (std::size_t i = 0; i < edges.size(); ++i)
      if (kept[i])
        {
          for (const cv::Point &p : edges[i].piece.pixels)
            result.at<uchar>(p) = 255;
          for (const int node : edges[i].nodes)
            ++n_kept[node];
        }
    for (std::size_t j = 0; j < junctions.size(); ++j)
      if (n_kept[j] > 1)
        for (const cv::Point &p : junctions[j])
          result.at<uchar>(p) = 255;
    return thin(result);
  }



  std::vector<int>
  LineGraph::parts(const std::vector<char> &kept) const
  {
    // Junctions lead to one another by the edges that are kept.
    std::vector<int> parent(junctions.size() + edges.size());
    std::iota(parent.begin(), parent.end(), 0);
    const auto root = [&](int i) {
      while (parent[i] != i)
        i = parent[i] = parent[parent[i]];
      return i;
    };
    for (std::size_t i = 0; i < edges.size(); ++i)
      if (kept[i])
        for (const int node : edges[i].nodes)
          parent[root(node)] = root(int(junctions.size() + i));
    std::vector<int> number(parent.size(), -1), part(edges.size(), -1);
    int              n = 0;
    for (std::size_t i = 0; i < edges.size(); ++i)
      if (kept[i])
        {
          int &k = number[root(int(junctions.size() + i))];
          if (k < 0)
            k = n++;
          part[i] = k;
        }
    return part;
  }
} // namespace squeal::tribology
