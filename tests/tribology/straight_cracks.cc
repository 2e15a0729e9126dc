// SPDX-License-Identifier: LGPL-2.1-or-later

// Straight cracks are told from grooves by what is beside them, not by their
// length; what is not found is listed or expected: a missed crack never reads
// 0 +- 0.
#include <squeal/tribology/images/centre_line.h>
#include <squeal/tribology/images/statistics.h>

#include <cmath>
#include <cstdio>

#include "check.h"
#include "tribology/line_score.h"
#include "tribology/straight_scenes.h"

using namespace squeal::testing;
using namespace squeal::tribology;

namespace
{
  constexpr int n_scenes = 6;

  LineScore
  score(const StraightScene &scene)
  {
    return score_lines(
      segment(scene.grey).cracks.centre_line, scene.cracks, 2.);
  }



  /** Cracks of 40 to 400 pixels; on half of the surfaces grooves run beside
   * them. Seeds that nothing was fitted to. */
  void
  check_scenes(const bool with_grooves)
  {
    double recall = 0., precision = 0.;
    for (int i = 0; i < n_scenes; ++i)
      {
        const LineScore s =
          score(straight_scene(910000U + unsigned(i), with_grooves));
        std::printf("scene %d%s: precision %.3f, recall %.3f\n",
                    i,
                    with_grooves ? " with grooves" : "",
                    s.precision,
                    s.recall);
        recall += s.recall / n_scenes;
        precision += s.precision / n_scenes;
      }
    std::printf("mean precision %.3f, recall %.3f\n", precision, recall);
    check(recall >= 0.8, "four fifths of straight cracks are found");
    check(precision >= 0.8, "four fifths of what is found is true");
  }



  /** The same scenes of 256 x 256 pixels: cracks are one pixel wide and half as
   * long. */
  void
  check_small_scenes()
  {
    double recall = 0., precision = 0.;
    for (int i = 0; i < n_scenes; ++i)
      {
        const StraightScene scene =
          straight_scene(910000U + unsigned(i), false);
        cv::Mat small;
        cv::resize(scene.grey, small, cv::Size(), 0.5, 0.5, cv::INTER_AREA);
        cv::Mat line = segment(small).cracks.centre_line;
        cv::resize(line, line, scene.grey.size(), 0., 0., cv::INTER_NEAREST);
        const LineScore s = score_lines(line, scene.cracks, 2.);
        std::printf("scene %d at half the resolution: precision %.3f, "
                    "recall %.3f\n",
                    i,
                    s.precision,
                    s.recall);
        recall += s.recall / n_scenes;
        precision += s.precision / n_scenes;
      }
    std::printf("mean precision %.3f, recall %.3f\n", precision, recall);
    check(recall >= 0.8, "four fifths of cracks of small images are found");
    check(precision >= 0.8, "four fifths of what is found there is true");
  }



  void
  check_drawn_crack(const double length)
  {
    cv::RNG           random(17);
    StraightScene     scene;
    const cv::Point2d c(256., 256.),
      half(0.5 * length * std::cos(0.4), 0.5 * length * std::sin(0.4));
    scene.grey   = grainy_surface(random);
    scene.cracks = cv::Mat::zeros(scene.grey.size(), CV_8U);
    darken_line(scene.grey, c - half, c + half, 2., 70.);
    cv::line(scene.cracks, c - half, c + half, 255);
    const auto            segmented = segment(scene.grey);
    const ImageStatistics s         = measure(segmented, 1., {});
    const LineScore       found =
      score_lines(segmented.cracks.centre_line, scene.cracks, 2.);
    std::printf("a straight crack of %g px: recall %.3f, %.1f +- %.1f px\n",
                length,
                found.recall,
                1e3 * s.crack_length,
                1e3 * s.crack_length_error);
    const std::string text = std::to_string(int(length)) + " px";
    check(found.recall > 0.95, "a straight crack of " + text + " is found");
    // A grain at its end may be taken for more of it.
    check(length < 100. || found.f1() > 0.9, "and little more at " + text);
    check(std::abs(1e3 * s.crack_length - length) <=
            2. * 1e3 * s.crack_length_error,
          "and has its length within two deviations");
  }



  /** Too faint to be found: the error says what may be there. */
  void
  check_missed_crack()
  {
    cv::RNG           random(5);
    const cv::Point2d a(150., 200.), b(350., 260.);
    cv::Mat           grey = grainy_surface(random);
    darken_line(grey, a, b, 1., 12.);
    const ImageStatistics s = measure(segment(grey), 1., {});
    std::printf("a faint crack of 209 px: %.1f +- %.1f px\n",
                1e3 * s.crack_length,
                1e3 * s.crack_length_error);
    check(s.crack_length_error > 0., "no crack is found for certain");
    check(s.crack_area_error > 0., "nor is its area");
  }
} // namespace



int
main()
{
  cv::setNumThreads(1);
  for (const double length : {40., 120., 200., 280., 400.})
    check_drawn_crack(length);
  check_missed_crack();
  check_scenes(false);
  check_scenes(true);
  check_small_scenes();
  return 0;
}
