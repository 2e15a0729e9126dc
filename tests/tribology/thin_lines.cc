// SPDX-License-Identifier: LGPL-2.1-or-later

// Thinned lines reach from end to end and are one pixel thin, in all directions
// and widths; slender pieces of masks without a line are told.
#include <squeal/tribology/images/centre_line.h>
#include <squeal/tribology/images/line_length.h>
#include <squeal/tribology/images/mask_line.h>

#include <opencv2/imgproc.hpp>

#include <cmath>
#include <cstdio>

#include "check.h"
#include "worst.h"

using namespace squeal;
using namespace squeal::testing;
using namespace squeal::tribology;

namespace
{
  constexpr int    n      = 190;  // pixels
  constexpr double length = 150.; // pixels

  /** The pixels within half of @p width of a straight line around @p middle. */
  cv::Mat
  straight_line(const double       width,
                const double       degrees,
                const cv::Point2d &middle)
  {
    cv::Mat      mask = cv::Mat::zeros(n, n, CV_8U);
    const double c    = std::cos(degrees * CV_PI / 180.),
                 s    = std::sin(degrees * CV_PI / 180.);
    for (int y = 0; y < n; ++y)
      for (int x = 0; x < n; ++x)
        {
          const double u = c * (x - middle.x) + s * (y - middle.y),
                       v = c * (y - middle.y) - s * (x - middle.x);
          if (std::abs(u) <= 0.5 * length && std::abs(v) <= 0.5 * width)
            mask.at<uchar>(y, x) = 255;
        }
    return mask;
  }



  double
  extent_of(const cv::Mat &mask)
  {
    const cv::Rect box = cv::boundingRect(mask);
    return std::hypot(box.width, box.height);
  }



  /** Pixels beside the way from end to end; all of them where there are
   * several pieces. */
  double
  beside_way(const cv::Mat &line)
  {
    const std::vector<LinePiece> pieces = line_pieces(line);
    return pieces.size() == 1
             ? double(pieces[0].pixels.size() - pieces[0].axis.size())
             : double(cv::countNonZero(line));
  }



  /** Straight lines: shorter at an end by the half width at most, and of the
   * length that was drawn when they are prolonged to the outline. */
  void
  check_all_directions()
  {
    cv::RNG random(1);
    Worst   missing, beside, off;
    int     n_lost = 0;
    for (double width = 1.; width <= 5.; width += 0.5)
      for (int degrees = 0; degrees < 180; ++degrees)
        {
          const cv::Point2d middle(95. + random.uniform(-0.5, 0.5),
                                   95. + random.uniform(-0.5, 0.5));
          const cv::Mat     mask = straight_line(width, degrees, middle);
          const cv::Mat     line = thin_marks(mask);
          const std::string place =
            cv::format("%.1f px at %d degrees", width, degrees);
          missing.add(length - width - extent_of(line), place);
          // A square end may fork towards its corners.
          beside.add(beside_way(line) - 0.5 * width, place);
          const MaskLine drawn = line_of_mask(mask);
          off.add(std::abs(cv::sum(pixel_lengths(drawn.line))[0] - length),
                  place);
          n_lost += int(drawn.without_line.size());
        }
    std::printf(
      "missing %.2f px, %s; beside the way %.1f px, %s; length off by "
      "%.2f px, %s\n",
      missing.largest(),
      missing.place_of_largest().c_str(),
      beside.largest(),
      beside.place_of_largest().c_str(),
      off.largest(),
      off.place_of_largest().c_str());
    check(missing.is_within(2.), "lines reach from end to end");
    check(beside.is_within(1.), "they are one pixel thin");
    check(off.is_within(4.), "and as long as what was drawn");
    check(n_lost == 0, "no piece lacks its line");
  }



  /** Diagonal zigzags by pens of all widths, and two lines a pixel apart. */
  void
  check_diagonals()
  {
    for (int pen = 1; pen <= 5; ++pen)
      {
        cv::Mat mask = cv::Mat::zeros(120, 300, CV_8U);
        for (int i = 0; i < 240; ++i)
          {
            const int y = 40 + (i / 40 % 2 == 0 ? i % 40 : 40 - i % 40);
            mask(cv::Rect(30 + i, y, pen, 1)).setTo(255);
          }
        const double drawn = cv::sum(pixel_lengths(line_of_mask(mask).line))[0];
        std::printf("zigzag by a pen of %d px: %.1f\n", pen, drawn);
        check_close(drawn,
                    240. * std::sqrt(2.),
                    0.03,
                    "a zigzag by a pen of " + std::to_string(pen) + " px");
      }
    for (const int sign : {1, -1})
      {
        cv::Mat mask = cv::Mat::zeros(n, n, CV_8U);
        for (int i = 0; i < 128; ++i)
          mask(cv::Rect(95 + sign * (i - 64), 30 + i, 2, 1)).setTo(255);
        const cv::Mat line = thin_marks(mask);
        check(beside_way(line) == 0. && cv::countNonZero(line) >= 127,
              "two diagonals side by side become one");
      }
  }



  /** A cross of spurs alone has no line left. */
  void
  check_lost_pieces()
  {
    cv::Mat mask = cv::Mat::zeros(60, 60, CV_8U);
    cv::line(mask, {10, 50}, {50, 50}, 255);
    cv::line(mask, {14, 20}, {26, 20}, 255);
    cv::line(mask, {20, 14}, {20, 26}, 255);
    cv::circle(mask, {45, 20}, 9, 255, cv::FILLED);
    const MaskLine drawn = line_of_mask(mask);
    check(drawn.without_line.size() == 1 &&
            drawn.without_line[0] == cv::Rect(14, 14, 13, 13),
          "a slender piece without a line is told, and no round one");
  }
} // namespace



int
main()
{
  check_all_directions();
  check_diagonals();
  check_lost_pieces();
  return 0;
}
