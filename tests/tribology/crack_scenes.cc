// SPDX-License-Identifier: LGPL-2.1-or-later

// Cracks and pits of drawn scenes: a crack ends where it ends, a dense network
// is no noise, a pit has its area, and what a branch hides counts once.
#include <squeal/tribology/images/areas.h>
#include <squeal/tribology/images/centre_line.h>
#include <squeal/tribology/images/segmentation.h>
#include <squeal/tribology/images/specimen_shapes.h>
#include <squeal/tribology/images/statistics.h>

#include <opencv2/imgproc.hpp>

#include <cmath>
#include <cstdio>

#include "check.h"
#include "tribology/line_score.h"

using namespace squeal::testing;
using namespace squeal::tribology;

namespace
{
  constexpr double bulk = 128., noise = 8.;
  constexpr int    fine = 8; // samples to a pixel, each way
  constexpr int    size = 600;

  cv::Mat
  fine_layer()
  {
    return cv::Mat::zeros(fine * size, fine * size, CV_8U);
  }



  /** A grey image with the share @p depth of the brightness missing where
   * @p layer is 255, blurred and with noise. */
  cv::Mat
  exposed(const cv::Mat &layer, const double depth)
  {
    cv::Mat cover, grey;
    cv::resize(layer, cover, cv::Size(size, size), 0., 0., cv::INTER_AREA);
    cover.convertTo(grey, CV_32F, -bulk * depth / 255., bulk);
    cv::GaussianBlur(grey, grey, cv::Size(), 0.7);
    cv::Mat grains(grey.size(), CV_32F);
    cv::RNG(7).fill(grains, cv::RNG::NORMAL, 0., noise);
    return grey + grains;
  }



  /** A wave from @p x0 to @p x1 at the height @p y, pixels: no groove. */
  PixelPath
  wave(const double x0, const double x1, const double y, const double phase)
  {
    PixelPath path;
    for (double x = x0; x <= x1; x += 0.5)
      path.emplace_back(
        cvRound(fine * (x + 0.5)),
        cvRound(fine * (y + 0.5 + 4. * std::sin(x / 9. + phase))));
    return path;
  }



  void
  draw(cv::Mat &layer, const PixelPath &path, const double width)
  {
    cv::polylines(layer, path, false, 255, cvRound(fine * width));
  }



  /** Mean of how far free ends lie beyond those of the drawn cracks. */
  void
  check_ends()
  {
    for (const double depth : {0.35, 0.7})
      {
        cv::Mat layer = fine_layer();
        int     n     = 0;
        for (double y = 60.; y < size - 40.; y += 60., ++n)
          draw(layer, wave(150., 450., y, 0.7 * n), 2.);
        const cv::Mat line = segment(exposed(layer, depth)).cracks.centre_line;
        double        left = 0., right = 0.;
        int           found = 0;
        for (const LinePiece &piece : line_pieces(line))
          {
            const cv::Rect box = cv::boundingRect(piece.pixels);
            left += 150. - box.x;
            right += box.br().x - 1 - 450.;
            ++found;
          }
        std::printf("depth %.2f: %d of %d cracks, ends %.2f, %.2f px beyond\n",
                    depth,
                    found,
                    n,
                    left / found,
                    right / found);
        const std::string text = " at depth " + std::to_string(depth);
        check(found == n, "each crack is found in one piece" + text);
        check(std::abs(left / found) < 1.5 && std::abs(right / found) < 1.5,
              "cracks end within 1.5 pixels on the mean" + text);
      }
  }



  /** Cracks 11 pixels apart fill some blocks of the noise. */
  void
  check_network()
  {
    cv::Mat layer = fine_layer();
    int     n     = 0;
    for (double y = 200.; y < 400.; y += 11., ++n)
      draw(layer, wave(100., 500., y, 0.), 2.5);
    cv::Mat drawn;
    cv::resize(layer, drawn, cv::Size(size, size), 0., 0., cv::INTER_AREA);
    const LineScore s = score_lines(
      segment(exposed(layer, 0.6)).cracks.centre_line, drawn > 127, 2.);
    std::printf("%d cracks side by side: precision %.3f, recall %.3f\n",
                n,
                s.precision,
                s.recall);
    check(s.recall > 0.9, "more than 90 % of a dense network is found");
    // Short bridges between neighbours are invented.
    check(s.precision > 0.75, "more than 75 % of that is true");
  }



  /** Rows of dashes with gaps of @p gap pixels, in which there is nothing. */
  void
  check_gaps(const double gap)
  {
    constexpr double dash  = 21.;
    cv::Mat          layer = fine_layer();
    double           drawn = 0.;
    for (int k = 0; k < 3; ++k)
      for (double x = 80.; x + dash < 520.; x += dash + gap)
        {
          const PixelPath path = wave(x, x + dash, 150. * (k + 1), k);
          draw(layer, path, 3.);
          drawn += cv::arcLength(path, false) / fine;
        }
    const Segmentation    found = segment(exposed(layer, 0.55));
    const ImageStatistics s     = measure(found, 1., {});
    std::printf("gaps of %g px: %.0f +- %.0f of %.0f px, %.0f bridged\n",
                gap,
                1e3 * s.crack_length,
                1e3 * s.crack_length_error,
                drawn,
                found.cracks.bridged);
    const std::string text = ", gaps of " + std::to_string(int(gap)) + " px";
    check(std::abs(1e3 * s.crack_length - drawn) <=
            2. * 1e3 * s.crack_length_error,
          "length within two deviations" + text);
    if (gap == 0.)
      check(found.cracks.bridged == 0., "a crack without gaps has none");
  }



  void
  check_pits()
  {
    for (const double radius : {8., 12., 30.})
      {
        cv::Mat layer = fine_layer();
        int     n     = 0;
        for (int y = 70; y < size; y += 100)
          for (int x = 70; x < size; x += 100, ++n)
            cv::circle(layer,
                       fine * cv::Point(x, y),
                       cvRound(fine * radius),
                       255,
                       cv::FILLED);
        const cv::Mat grey = exposed(layer, 0.5);
        const AreaMap areas =
          find_areas(grey, cv::Mat::zeros(grey.size(), CV_8U), AreaSettings());
        const double ratio =
          cv::countNonZero(areas.exfoliation) / (n * CV_PI * radius * radius);
        std::printf(
          "pits of radius %.0f: area %.3f of the true one\n", radius, ratio);
        // Small pits are as wide as the means that find them.
        const double within = radius < 10. ? 0.1 : 0.05;
        check(std::abs(ratio - 1.) < within,
              "the area of pits is right within " + std::to_string(within) +
                " at radius " + std::to_string(radius));
      }
  }



  CrackShape
  straight_crack(const cv::Point2d &a, const cv::Point2d &b, const double width)
  {
    CrackShape crack;
    crack.line  = {a, b};
    crack.width = {width, width};
    crack.depth = {0.5, 0.5};
    return crack;
  }



  void
  check_seen_length()
  {
    const cv::Size2d view(200., 100.);
    const CrackShape parent = straight_crack({-40., 50.}, {80., 50.}, 20.);
    check_close(seen_crack_length({parent}, view),
                80.,
                1e-12,
                "what lies outside of the view is not seen");
    const CrackShape branch = straight_crack({40., 50.}, {40., 74.}, 4.);
    check_close(seen_crack_length({parent, branch}, view),
                80. + 14.,
                1e-12,
                "the beginning of a branch inside its parent counts once");
    const CrackShape apart = straight_crack({150., 10.}, {150., 34.}, 4.);
    check_close(seen_crack_length({parent, branch, apart}, view),
                80. + 14. + 24.,
                1e-12,
                "a crack apart counts as a whole");
  }
} // namespace



int
main()
{
  cv::setNumThreads(1);
  check_ends();
  check_network();
  for (const double gap : {0., 12., 18., 27.})
    check_gaps(gap);
  check_pits();
  check_seen_length();
  return 0;
}
