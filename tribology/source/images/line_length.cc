// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/tribology/images/centre_line.h>
#include <squeal/tribology/images/line_length.h>
#include <squeal/tribology/images/line_smoothing.h>

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>

namespace squeal::tribology
{
  namespace
  {
    constexpr double weight_smoothing =
      1.25;                  // pixels, deviation of the weights
    constexpr int reach = 4; // pixels, of the weights

    /** Variance of the steps of a smoothed line, pixels^2: rounding errors are
     * uniform, of variance 1/12, and those of different pixels independent;
     * twiced() weighs them with 2 g - g * g for weights g of the mean. */
    double
    step_variance(const std::vector<double> &g)
    {
      const int           n = int(g.size());
      std::vector<double> h(2 * n + 1, 0.); // begins and ends with zero
      for (int i = 0; i < n; ++i)
        {
          h[i + reach + 1] += 2. * g[i];
          for (int j = 0; j < n; ++j)
            h[i + j + 1] -= g[i] * g[j];
        }
      double sum = 0.;
      for (std::size_t i = 1; i < h.size(); ++i)
        sum += (h[i] - h[i - 1]) * (h[i] - h[i - 1]);
      return sum / 12.;
    }

    /** The links of a skeleton: steps between neighbours, but no diagonal
     * beside two straight steps, which is the corner of a staircase. */
    class Links
    {
    public:
      explicit Links(const cv::Mat &skeleton)
        : line(skeleton)
        , inside({0, 0}, skeleton.size())
      {
      }

      bool
      has(const cv::Point &p, const int k) const
      {
        if (!is_set(p + neighbour_steps[k]))
          return false;
        return k % 2 == 0 || (!is_set(p + neighbour_steps[k - 1]) &&
                              !is_set(p + neighbour_steps[(k + 1) % 8]));
      }

      int
      n(const cv::Point &p) const
      {
        int sum = 0;
        for (int k = 0; k < 8; ++k)
          sum += has(p, k);
        return sum;
      }

    private:
      bool
      is_set(const cv::Point &q) const
      {
        return inside.contains(q) && line.at<uchar>(q) != 0;
      }

      const cv::Mat  line;
      const cv::Rect inside;
    };



    /** Smoothed by twicing: what the mean takes from a bend is averaged and
     * added again. The bend loses the fourth power of (deviation over radius)
     * instead of the second. */
    Curve
    twiced(const Curve               &line,
           const bool                 is_ring,
           const std::vector<double> &weights)
    {
      const Curve mean = averaged_along(line, is_ring, weights);
      Curve       rest = line;
      for (std::size_t i = 0; i < line.size(); ++i)
        rest[i] = line[i] - mean[i];
      rest = averaged_along(rest, is_ring, weights);
      for (std::size_t i = 0; i < line.size(); ++i)
        rest[i] += mean[i];
      return rest;
    }



    /** Gives the length of each edge of a skeleton to its pixels. */
    class Measurement
    {
    public:
      explicit Measurement(const cv::Mat &skeleton)
        : links(skeleton)
        , weights(mean_weights(weight_smoothing, reach))
        , variance(step_variance(weights))
        , degree(cv::Mat1b::zeros(skeleton.size()))
        , lengths(cv::Mat1f::zeros(skeleton.size()))
        , done(cv::Mat1b::zeros(skeleton.size()))
      {
        cv::findNonZero(skeleton, pixels);
        for (const cv::Point &p : pixels)
          degree(p) = uchar(links.n(p));
        cv::connectedComponentsWithStats(
          degree > 2, nodes, stats, centres, 8, CV_32S);
      }

      cv::Mat
      operator()()
      {
        for (const cv::Point &p : pixels)
          {
            if (degree(p) == 0)
              lengths(p) += 1.F;
            if (degree(p) != 2)
              for (int k = 0; k < 8; ++k)
                if (links.has(p, k))
                  follow(p, k);
          }
        // What is left are rings.
        for (const cv::Point &p : pixels)
          if (degree(p) == 2 && done(p) == 0)
            for (int k = 0; k < 8 && done(p) == 0; ++k)
              if (links.has(p, k))
                follow(p, k);
        return lengths;
      }

    private:
      /** The edge that leaves @p start by step @p k. */
      void
      follow(const cv::Point &start, int k)
      {
        PixelPath path = {start};
        for (;;)
          {
            const cv::Point p = path.back() + neighbour_steps[k];
            path.push_back(p);
            if (degree(p) != 2 || p == start)
              break;
            done(p) = 1;
            // On along the link that does not lead back.
            const int back = (k + 4) % 8;
            for (k = 0; k == back || !links.has(p, k);)
              ++k;
          }
        const cv::Point end = path.back();
        // Links within a node are part of it, and an edge between two nodes
        // is met from both sides.
        if (nodes(start) > 0 && nodes(start) == nodes(end) && path.size() < 3)
          return;
        const bool is_ring = start == end && degree(start) == 2;
        if (!is_ring && met_before(path))
          return;
        Curve line;
        for (const cv::Point &p : path)
          line.push_back(nodes(p) > 0 ? centre(p) : cv::Point2d(p));
        line = twiced(line, is_ring, weights);
        for (std::size_t i = 1; i < path.size(); ++i)
          {
            const float half = float(0.5 * step_length(line[i] - line[i - 1]));
            lengths(path[i]) += half;
            lengths(path[i - 1]) += half;
          }
        if (is_ring)
          done(start) = 1;
        const std::size_t n = line.size();
        if (degree(start) == 1)
          lengths(start) += float(half_step(line[1] - line[0]));
        if (degree(end) == 1)
          lengths(end) += float(half_step(line[n - 2] - line[n - 1]));
      }

      /** From the other end, by the order of the ends or of the first steps. */
      static bool
      met_before(const PixelPath &path)
      {
        const auto less = [](const cv::Point &a, const cv::Point &b) {
          return a.y != b.y ? a.y < b.y : a.x < b.x;
        };
        const cv::Point &a = path.front(), &b = path.back();
        return a == b ? less(path[path.size() - 2], path[1]) : less(b, a);
      }

      cv::Point2d
      centre(const cv::Point &p) const
      {
        const int n = nodes(p);
        return {centres(n, 0), centres(n, 1)};
      }

      /** Length of a step, less what the rest of the rounding errors adds on
       * the mean: a step (1, t) whose t has the variance v is longer by
       * v / (2 (1 + t^2)^(3/2)). */
      double
      step_length(const cv::Point2d &d) const
      {
        const double length  = cv::norm(d);
        const double largest = std::max(std::abs(d.x), std::abs(d.y));
        return length > 0. ? length - 0.5 * variance * largest * largest /
                                        (length * length * length)
                           : 0.;
      }

      /** From the centre of a pixel to its border along a line. */
      static double
      half_step(const cv::Point2d &d)
      {
        const double largest = std::max(std::abs(d.x), std::abs(d.y));
        return largest > 0. ? 0.5 * cv::norm(d) / largest : 0.5;
      }

      const Links               links;
      const std::vector<double> weights;
      const double              variance;
      cv::Mat1b                 degree;
      cv::Mat1f                 lengths;
      cv::Mat1b                 done;
      PixelPath                 pixels;
      cv::Mat1i                 nodes, stats;
      cv::Mat1d                 centres;
    };
  } // namespace



  cv::Mat
  pixel_lengths(const cv::Mat &skeleton)
  {
    return Measurement(skeleton)();
  }



  double
  length_of_pixels(const std::vector<cv::Point> &line)
  {
    if (line.empty())
      return 0.;
    // A border, so that no pixel lies at the rim of the drawing.
    const cv::Rect box = cv::boundingRect(line);
    cv::Mat drawing    = cv::Mat::zeros(box.height + 2, box.width + 2, CV_8U);
    for (const cv::Point &p : line)
      drawing.at<uchar>(p - box.tl() + cv::Point(1, 1)) = 255;
    return cv::sum(pixel_lengths(drawing))[0];
  }
} // namespace squeal::tribology
