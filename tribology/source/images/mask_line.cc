// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/tribology/images/centre_line.h>
#include <squeal/tribology/images/mask_line.h>

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>

namespace squeal::tribology
{
  namespace
  {
    constexpr int longest_mask_spur = 6; // pixels
    // A skeleton ends within that of the outline: half widths and pixels.
    constexpr double before_outline = 2., and_pixels = 2.;
    constexpr double of_half_width = 0.5; // deviation of an end
    // A piece of a mask that is so long, in pixels and over its width, is a
    // line, of which so much must be left.
    constexpr double least_extent = 10., least_slenderness = 3.;
    constexpr double least_left = 0.5;

    /** Distance of the pixels of a mask from its outline, pixels. */
    cv::Mat1f
    half_widths_of(const cv::Mat &mask)
    {
      cv::Mat1f half;
      if (cv::countNonZero(mask) == int(mask.total()))
        return cv::Mat1f::zeros(mask.size());
      cv::distanceTransform(mask, half, cv::DIST_L2, cv::DIST_MASK_PRECISE);
      return cv::max(half - 0.5F, 0.F);
    }



    /** The last pixel of @p mask on the straight way on from an end; the tip
     * where another line is met. */
    cv::Point
    last_on_way(const cv::Mat &line,
                const cv::Mat &mask,
                const LineEnd &end,
                const double   farthest)
    {
      const cv::Rect inside({0, 0}, mask.size());
      const auto     ahead = [&end](const double d) {
        return cv::Point(cvRound(end.tip.x + d * end.ahead.x),
                         cvRound(end.tip.y + d * end.ahead.y));
      };
      double reach = 0.;
      for (double d = 1.; d <= farthest; d += 0.5)
        {
          const cv::Point q = ahead(d);
          if (!inside.contains(q) || mask.at<uchar>(q) == 0)
            break;
          if (q != end.tip && line.at<uchar>(q) != 0)
            return end.tip;
          reach = d;
        }
      return ahead(reach);
    }


    /** Prolongs the free ends of @p line straight on to the outline of
     * @p mask, of the distances @p half. */
    void
    reach_ends(cv::Mat &line, const cv::Mat &mask, const cv::Mat1f &half)
    {
      const cv::Mat before = line.clone();
      for (const LineEnd &end : line_ends(before))
        {
          double widest = 0.;
          for (const cv::Point &p : end.behind)
            widest = std::max(widest, double(half(p)));
          cv::line(line,
                   end.tip,
                   last_on_way(
                     before, mask, end, before_outline * widest + and_pixels),
                   255);
        }
      line = thin_marks(line);
    }



    /** Boxes of the slender pieces of @p mask, of the distances @p half, of
     * which @p line reaches over less than a half. */
    std::vector<cv::Rect>
    pieces_without_line(const cv::Mat   &mask,
                        const cv::Mat   &line,
                        const cv::Mat1f &half)
    {
      cv::Mat1i              labels;
      const int              n = cv::connectedComponents(mask, labels, 8);
      std::vector<cv::Rect>  pieces(n), lines(n);
      std::vector<float>     widest(n, 0.F);
      std::vector<cv::Point> pixels;
      cv::findNonZero(mask, pixels);
      for (const cv::Point &p : pixels)
        {
          const int      l = labels(p);
          const cv::Rect pixel(p.x, p.y, 1, 1);
          pieces[l] |= pixel; // an empty box is none
          widest[l] = std::max(widest[l], half(p));
          if (line.at<uchar>(p) != 0)
            lines[l] |= pixel;
        }
      const auto extent = [](const cv::Rect &box) {
        return std::hypot(box.width, box.height);
      };
      std::vector<cv::Rect> result;
      for (int l = 1; l < n; ++l)
        if (extent(pieces[l]) >= least_extent &&
            extent(pieces[l]) >= least_slenderness * (2. * widest[l] + 1.) &&
            extent(lines[l]) < least_left * extent(pieces[l]))
          result.push_back(pieces[l]);
      return result;
    }
  } // namespace



  MaskLine
  line_of_mask(const cv::Mat &mask)
  {
    const cv::Mat1f half = half_widths_of(mask);
    MaskLine        result;
    result.line = thin_marks(mask);
    remove_spurs(result.line, longest_mask_spur, half);
    double square = 0.;
    for (const LineEnd &end : line_ends(result.line))
      {
        double widest = 0.;
        for (const cv::Point &p : end.behind)
          widest = std::max(widest, double(half(p)));
        square += std::pow(of_half_width * std::max(0., widest - 0.5), 2);
      }
    result.end_error = std::sqrt(square);
    reach_ends(result.line, mask, half);
    result.without_line = pieces_without_line(mask, result.line, half);
    return result;
  }
} // namespace squeal::tribology
