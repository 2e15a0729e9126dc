// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/tribology/images/area_evidence.h>

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <vector>

namespace squeal::tribology
{
  namespace
  {
    // The brightness on both sides of an outline, pixels from it.
    constexpr float ring_begin = 2.F, ring_end = 4.5F;
    // Step at the outline over the depth of the area.
    constexpr double least_rim = 0.65;
    // Share of an outline that may lie on the border of the image.
    constexpr double most_border = 0.4;
    // Area over that of the largest disc in it.
    constexpr double longest_area = 6.;

    struct Part
    {
      double area = 0., depth = 0., radius = 0.;
      double inside = 0., n_inside = 0., outside = 0., n_outside = 0.;
      double outline = 0., at_border = 0.;

      bool
      has_rim(const double least_step) const
      {
        if (n_inside == 0. || n_outside == 0.)
          return false;
        const double step = outside / n_outside - inside / n_inside;
        return step >= least_step && step >= least_rim * depth / area &&
               at_border <= most_border * outline &&
               area <= longest_area * CV_PI * radius * radius;
      }
    };



    /** Whether a neighbour of a pixel does not belong to the part. */
    bool
    is_outline(const cv::Mat1i &labels, const int x, const int y)
    {
      for (const cv::Point &d : {cv::Point(1, 0),
                                 cv::Point(-1, 0),
                                 cv::Point(0, 1),
                                 cv::Point(0, -1)})
        {
          const cv::Point q(x + d.x, y + d.y);
          if (q.x < 0 || q.y < 0 || q.x >= labels.cols || q.y >= labels.rows ||
              labels(q) != labels(y, x))
            return true;
        }
      return false;
    }



    /** The outermost pixels of what is seen, CV_8U. */
    cv::Mat
    border_of(const cv::Size &size, const SeenPixels &seen)
    {
      cv::Mat border = cv::Mat::zeros(size, CV_8U);
      if (!seen.empty())
        cv::dilate(~seen, border, cv::Mat());
      cv::rectangle(border, cv::Rect({0, 0}, size), 255);
      return border;
    }



    /** What is measured of each part of @p areas, by its label. */
    std::vector<Part>
    measure_parts(const cv::Mat   &areas,
                  const cv::Mat1i &labels,
                  const int        n_labels,
                  const cv::Mat1f &flat,
                  const cv::Mat   &left_out,
                  const cv::Mat   &border)
    {
      cv::Mat1f depth, distance;
      cv::Mat1i nearest;
      cv::distanceTransform(areas, depth, cv::DIST_L2, 5);
      cv::distanceTransform(
        ~areas, distance, nearest, cv::DIST_L2, 5, cv::DIST_LABEL_PIXEL);
      // The label of the part whose pixel is the nearest to a place outside.
      std::vector<int> part_of(areas.total() + 1, 0);
      for (int y = 0; y < areas.rows; ++y)
        for (int x = 0; x < areas.cols; ++x)
          if (labels(y, x) > 0)
            part_of[nearest(y, x)] = labels(y, x);
      const auto is_in_ring = [](const float d) {
        return d >= ring_begin && d < ring_end;
      };
      std::vector<Part> parts(n_labels);
      for (int y = 0; y < areas.rows; ++y)
        for (int x = 0; x < areas.cols; ++x)
          {
            const int  l       = labels(y, x);
            const bool is_line = left_out.at<uchar>(y, x) != 0;
            if (l == 0)
              {
                if (is_in_ring(distance(y, x)) && !is_line)
                  {
                    Part &p = parts[part_of[nearest(y, x)]];
                    p.outside += flat(y, x);
                    p.n_outside += 1.;
                  }
                continue;
              }
            Part &p = parts[l];
            p.area += 1.;
            p.depth -= flat(y, x);
            p.radius = std::max(p.radius, double(depth(y, x)));
            if (is_in_ring(depth(y, x)) && !is_line)
              {
                p.inside += flat(y, x);
                p.n_inside += 1.;
              }
            if (is_outline(labels, x, y))
              {
                p.outline += 1.;
                p.at_border += border.at<uchar>(y, x) != 0;
              }
          }
      return parts;
    }
  } // namespace



  AreasWithoutRim
  take_without_rim(cv::Mat          &areas,
                   const cv::Mat1f  &flat,
                   const cv::Mat    &lines,
                   const double      least_step,
                   const SeenPixels &seen)
  {
    AreasWithoutRim result{cv::Mat::zeros(areas.size(), CV_8U), 0.};
    if (cv::countNonZero(areas) == 0)
      return result;
    cv::Mat1i     labels;
    const int     n        = cv::connectedComponents(areas, labels, 8);
    const cv::Mat left_out = seen.empty() ? lines : cv::Mat(lines | ~seen);
    const std::vector<Part> parts = measure_parts(
      areas, labels, n, flat, left_out, border_of(areas.size(), seen));
    std::vector<char> stays(n, 0);
    for (int l = 1; l < n; ++l)
      {
        const Part &p = parts[l];
        stays[l]      = p.has_rim(least_step);
        if (stays[l])
          result.cut_off += p.area * 2. * p.at_border / p.outline;
      }
    for (int y = 0; y < areas.rows; ++y)
      for (int x = 0; x < areas.cols; ++x)
        if (labels(y, x) > 0 && !stays[labels(y, x)])
          {
            areas.at<uchar>(y, x)        = 0;
            result.taken.at<uchar>(y, x) = 255;
          }
    return result;
  }



  double
  outline_length(const cv::Mat &areas, const SeenPixels &seen)
  {
    const cv::Mat border = border_of(areas.size(), seen);
    cv::Mat1i     labels;
    areas.convertTo(labels, CV_32S);
    double length = 0.;
    for (int y = 0; y < areas.rows; ++y)
      for (int x = 0; x < areas.cols; ++x)
        length += labels(y, x) != 0 && is_outline(labels, x, y) &&
                  border.at<uchar>(y, x) == 0;
    return length;
  }
} // namespace squeal::tribology
