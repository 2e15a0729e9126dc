// SPDX-License-Identifier: LGPL-2.1-or-later

// Rows that a scan darkened are no cracks, cracks along the rows are.
#include <squeal/tribology/images/scan_rows.h>
#include <squeal/tribology/images/segmentation.h>

#include <algorithm>
#include <cstdio>

#include "check.h"
#include "line_score.h"
#include "straight_scenes.h"

using namespace squeal;
using namespace squeal::testing;
using namespace squeal::tribology;

namespace
{
  /** Pieces of one to three rows, 80 to 270 pixels long. */
  void
  check_dark_rows(const unsigned int seed)
  {
    cv::RNG       random(seed);
    cv::Mat       grey     = grainy_surface(random);
    const int     n_before = cv::countNonZero(segment(grey).cracks.centre_line);
    constexpr int n        = 12;
    for (int i = 0; i < n; ++i)
      {
        const int length = random.uniform(80, 270), rows = 1 + i % 3,
                  x = random.uniform(10, 500 - length);
        grey(cv::Rect(x, 30 + 38 * i, length, rows)) -= 25.;
      }
    const Segmentation found   = segment(grey);
    const int          n_rows  = int(std::count_if(
      found.excluded.begin(),
      found.excluded.end(),
      [](const ExcludedLine &line) { return line.reason == Exclusion::scan; }));
    const int          n_after = cv::countNonZero(found.cracks.centre_line);
    std::printf(
      "%d of %d dark rows, %d pixels of cracks, %d without the rows\n",
      n_rows,
      n,
      n_after,
      n_before);
    check(n_after <= n_before, "dark rows of the scan are no cracks");
    check(n_rows >= n, "they are listed");
  }



  /** A crack exactly along the rows, its middle on a row or between two. */
  void
  check_crack_along_rows(const double width, const double place)
  {
    cv::RNG       random(7);
    StraightScene scene;
    scene.grey   = grainy_surface(random);
    scene.cracks = cv::Mat::zeros(scene.grey.size(), CV_8U);
    darken_line(scene.grey, {100., place}, {400., place}, width, 70.);
    cv::line(scene.cracks, {100, int(place)}, {400, int(place)}, 255);
    check(without_scan_rows(scene.grey).pieces.empty(),
          "a crack along the rows is not of the scan");
    const LineScore score =
      score_lines(segment(scene.grey).cracks.centre_line, scene.cracks, 2.);
    std::printf("width %g at %g: recall %.2f\n", width, place, score.recall);
    check(score.recall > 0.95, "and is found");
  }

  /** A line drawn along a row without optics: a crack, as it is alone. */
  void
  check_drawn_line()
  {
    cv::RNG       random(7);
    StraightScene scene;
    scene.grey   = grainy_surface(random);
    scene.cracks = cv::Mat::zeros(scene.grey.size(), CV_8U);
    scene.grey(cv::Rect(100, 200, 200, 2)) -= 70.;
    cv::line(scene.cracks, {100, 200}, {299, 200}, 255);
    const Segmentation found = segment(scene.grey);
    const LineScore    score =
      score_lines(found.cracks.centre_line, scene.cracks, 2.);
    std::printf("drawn: recall %.2f\n", score.recall);
    check(score.recall > 0.95, "a line that is drawn along a row is found");
    check(found.rows_like_scan.size() == 1, "and is told to be like a row");
    check(found.cracks.doubt.invented >= 190., "which its error holds");
  }
} // namespace



int
main()
{
  cv::setNumThreads(1);
  for (const unsigned int seed : {1U, 2U, 3U})
    check_dark_rows(seed);
  for (const double width : {1., 2., 3.})
    for (const double place : {200., 200.5})
      check_crack_along_rows(width, place);
  check_drawn_line();
  return 0;
}
