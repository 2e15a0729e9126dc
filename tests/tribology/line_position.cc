// SPDX-License-Identifier: LGPL-2.1-or-later

// Centre lines that are moved to the middle of drawn dark lines.
#include <squeal/tribology/images/centre_line.h>
#include <squeal/tribology/images/line_position.h>

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "check.h"

using namespace squeal;
using namespace squeal::testing;
using namespace squeal::tribology;

namespace
{
  constexpr double bright = 180., shaded = 150., dark = 50.; // grey levels
  constexpr double noise = 10.;                              // grey levels
  constexpr int    n = 200, end = 10;                        // pixels

  /** Height of the middle of the line over x, pixels. */
  double
  middle(const double x)
  {
    return 100.3 + 6. * std::sin(x / 15.);
  }



  /** A dark line of @p width pixels between a bright and a shaded side, each
   * pixel the mean over itself. */
  cv::Mat
  drawn_line(const double width)
  {
    constexpr int n_parts = 8;
    cv::Mat1f     grey(n, n, 0.F);
    cv::RNG       random(1);
    for (int y = 0; y < n; ++y)
      for (int x = 0; x < n; ++x)
        {
          for (int k = 0; k < n_parts; ++k)
            {
              const double d = y - 0.5 + (k + 0.5) / n_parts - middle(x);
              const double v = std::abs(d) < 0.5 * width ? dark
                               : d < 0.                  ? bright
                                                         : shaded;
              grey(y, x) += float(v / n_parts);
            }
          grey(y, x) += float(random.gaussian(noise));
        }
    return grey;
  }



  /** A skeleton on the shaded side of the middle that steps up and down. */
  cv::Mat
  line_aside()
  {
    cv::Mat line = cv::Mat::zeros(n, n, CV_8U);
    for (int x = end; x < n - end; ++x)
      cv::line(line,
               {x, cvRound(middle(x) + 1.5)},
               {x + 1, cvRound(middle(x + 1) + (x % 9 < 4 ? 2.5 : 0.5))},
               255);
    return thin(line);
  }



  struct Distances
  {
    double mean = 0., rms = 0.; /**< pixels, downwards */
  };

  Distances
  from_middle(const cv::Mat &line)
  {
    PixelPath pixels;
    cv::findNonZero(line, pixels);
    Distances result;
    for (const cv::Point &p : pixels)
      {
        const double slope    = 0.4 * std::cos(p.x / 15.);
        const double distance = (p.y - middle(p.x)) / std::hypot(1., slope);
        result.mean += distance / pixels.size();
        result.rms += distance * distance / pixels.size();
      }
    result.rms = std::sqrt(result.rms);
    return result;
  }



  void
  check_distances()
  {
    const cv::Mat   before      = line_aside();
    const Distances at_the_side = from_middle(before);
    check(at_the_side.mean > 1.2, "the line lies beside the middle at first");
    for (const double width : {1.5, 3., 5.})
      {
        const cv::Mat   after  = move_to_middle(drawn_line(width), before);
        const Distances centre = from_middle(after);
        std::printf("width %.1f px: from %.2f px, rms %.2f, to %.2f px, rms "
                    "%.2f\n",
                    width,
                    at_the_side.mean,
                    at_the_side.rms,
                    centre.mean,
                    centre.rms);
        const std::string name = cv::format("line of %.1f px: ", width);
        check(std::abs(centre.mean) < 0.5,
              name + "on average within 0.5 px of the middle of the profile");
        // Rounding to pixels alone makes 0.29.
        check(centre.rms < 0.6, name + "root mean square below 0.6 px");
        check(line_pieces(after).size() == 1 && line_ends(after).size() == 2,
              name + "one piece with two ends");
        const cv::Rect old = cv::boundingRect(before);
        const cv::Rect box = cv::boundingRect(after);
        check(std::abs(box.x - old.x) <= 3 &&
                std::abs(box.br().x - old.br().x) <= 3,
              name + "the ends move across the line only");
      }
  }



  void
  check_branches()
  {
    // A branch that leaves the line upwards, and a ring apart from both.
    cv::Mat line = line_aside();
    cv::line(line, {100, cvRound(middle(100.) + 1.5)}, {130, 40}, 255);
    line = thin(line);
    cv::circle(line, {40, 170}, 15, 255);
    const cv::Mat before = thin(line);
    cv::Mat       grey   = drawn_line(3.);
    cv::line(grey, {100, 100}, {130, 40}, dark, 3);
    const cv::Mat after = move_to_middle(grey, before);
    check(line_ends(before).size() == 3 && line_ends(after).size() == 3 &&
            line_pieces(after).size() == 2,
          "a branch stays connected");
    const cv::Rect ring(20, 150, 40, 40);
    check(cv::countNonZero(before(ring) != after(ring)) == 0, "a ring stays");
    check(cv::countNonZero(move_to_middle(grey, cv::Mat::zeros(n, n, CV_8U))) ==
            0,
          "nothing comes of nothing");
  }
} // namespace



int
main()
{
  check_distances();
  check_branches();
  return 0;
}
