// SPDX-License-Identifier: LGPL-2.1-or-later

// Lines of two raters are one line up to the tolerance and two beyond, where
// each of them was drawn; of three raters two must have a line.
#include <squeal/tribology/images/agreement.h>
#include <squeal/tribology/images/centre_line.h>
#include <squeal/tribology/images/line_length.h>

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>

#include "check.h"

using namespace squeal;
using namespace squeal::testing;
using namespace squeal::tribology;

namespace
{
  double
  length_in(const cv::Mat &line)
  {
    return cv::sum(pixel_lengths(line))[0];
  }



  /** Lines of two raters are one up to the tolerance and two beyond; of three
   * raters two must lie so near, and one goes no farther than another one. */
  void
  check_lines_apart()
  {
    const auto drawn = [](const int y, const int last, const double wave) {
      cv::Mat                line = cv::Mat::zeros(200, 400, CV_8U);
      std::vector<cv::Point> way;
      for (int x = 50; x <= last; ++x)
        way.emplace_back(x, y + cvRound(wave * std::sin(x / 15.)));
      cv::polylines(line, way, false, 255);
      return thin(line);
    };
    for (const double wave : {0., 8.})
      for (const double tolerance : {0., 2., 5., 20.})
        for (int apart = 0; apart < 30; ++apart)
          {
            const cv::Mat     a    = drawn(100, 300, wave);
            const cv::Mat     b    = drawn(100 + apart, 300, wave);
            const cv::Mat     none = drawn(20, 300, 0.);
            const std::string text = ", " + std::to_string(apart) +
                                     " px apart at a tolerance of " +
                                     std::to_string(int(tolerance));
            const double one    = length_in(a);
            const bool   is_one = apart <= std::max(1., tolerance);
            if (wave > 0. && apart > 0.5 * std::max(2., tolerance) &&
                apart < 2. * std::max(2., tolerance))
              continue; // the wave's flanks lie nearer than that
            check_close(length_in(consensus_line({a, b}, tolerance)),
                        is_one ? one : 2. * one,
                        0.05,
                        "two raters" + text);
            if (apart != 1 || tolerance > 0.)
              check_close(length_in(consensus_line({a, b, none}, tolerance)),
                          is_one ? one : 0.,
                          0.05,
                          "three raters" + text);
          }
    check_close(
      length_in(consensus_line(
        {drawn(100, 250, 0.), drawn(101, 300, 0.), drawn(100, 350, 0.)}, 20.)),
      length_in(drawn(100, 300, 0.)),
      2. / 250.,
      "as long as two of three have it");
  }
} // namespace



int
main()
{
  check_lines_apart();
}
