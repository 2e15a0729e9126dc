// SPDX-License-Identifier: LGPL-2.1-or-later

// Widths of cracks in images that are out of focus: the blur is measured, and
// where anything is sharp it is that of a lens in focus. The error of widths
// holds images that are sharper, as reduced ones, however many cracks they
// show.
#include <squeal/tribology/images/crack_depth.h>
#include <squeal/tribology/images/image_blur.h>
#include <squeal/tribology/images/segmentation.h>
#include <squeal/tribology/images/statistics.h>

#include <opencv2/imgproc.hpp>

#include <cmath>
#include <cstdio>
#include <string>

#include "check.h"
#include "straight_scenes.h"

using namespace squeal;
using namespace squeal::testing;
using namespace squeal::tribology;

namespace
{
  /** Straight cracks of one width, 60 % deep, under optics of a blur; one on an
   * even surface, or five. */
  cv::Mat
  blurred_scene(const double width, const double blur, const int n_cracks)
  {
    cv::RNG random(11);
    cv::Mat grey(400, 500, CV_32F, cv::Scalar(120.));
    for (int i = 0; i < n_cracks; ++i)
      {
        const double      angle = 0.5 + 0.3 * (i - 2);
        const cv::Point2d along(std::cos(angle), std::sin(angle)),
          c(n_cracks == 1 ? 250. : 80. + 85. * i, 200.);
        for (int y = 0; y < grey.rows; ++y)
          for (int x = 0; x < grey.cols; ++x)
            {
              const cv::Point2d d = cv::Point2d(x, y) - c;
              if (std::abs(d.dot(along)) > 150.)
                continue;
              const double cover = std::clamp(
                0.5 * width + 0.5 - std::abs(along.cross(d)), 0., 1.);
              grey.at<float>(y, x) *= float(1. - 0.6 * cover);
            }
      }
    if (blur > 0.)
      cv::GaussianBlur(grey, grey, cv::Size(), blur);
    cv::Mat noise(grey.size(), CV_32F);
    random.fill(noise, cv::RNG::NORMAL, 0., 3.);
    return grey + noise;
  }



  void
  check_width(const double width, const double blur, const int n_cracks)
  {
    const Segmentation    found = segment(blurred_scene(width, blur, n_cracks));
    const ImageStatistics s     = measure(found, 1., 0.);
    const OpticalBlur     measured = found.cracks.blur;
    std::printf("width %g, blur %g, %d: %.2f +- %.2f, blur %.2f +- %.2f%s\n",
                width,
                blur,
                n_cracks,
                s.crack_width,
                s.crack_width_error,
                measured.value,
                measured.error * measured.value,
                measured.is_measured ? "" : " (assumed)");
    const std::string text =
      " at width " + std::to_string(width) + ", blur " + std::to_string(blur);
    check(s.crack_length > 0., "cracks are found" + text);
    check(std::abs(s.crack_width - width) <= 2. * s.crack_width_error,
          "the width is within two deviations" + text);
    check(measured.is_measured == (blur > 1.3),
          "an image out of focus is told from one in focus" + text);
    if (measured.is_measured)
      check(std::abs(std::log(measured.value / blur)) <
              std::max(0.2, 2. * measured.error),
            "and by how much" + text);
  }



  /** Cracks of one width and depth under optics sharper than, and as, those of
   * a lens in focus: the more of them, the surer would each be, were they no
   * common error. */
  void
  check_cracks_alike(const double width, const double depth, const double blur)
  {
    // of pixels, and of profiles, as the theory has them, pixels^2
    const double b   = std::sqrt(blur * blur + 0.673);
    const Dip    dip = {width * depth,
                        depth * std::erf(width / (2. * std::sqrt(2.) * b))};
    for (const std::size_t n : {5, 30})
      {
        const CrackDepth::Width w =
          CrackDepth(std::vector<std::vector<Dip>>(n, {dip}), 0.).width(dip);
        const double error = std::hypot(w.own / std::sqrt(double(n)), w.common);
        std::printf("%zu cracks of %g, depth %g, blur %g: %.2f +- %.2f\n",
                    n,
                    width,
                    depth,
                    blur,
                    w.value,
                    error);
        check(std::abs(w.value - width) <= 2. * error && error < width,
              std::to_string(n) + " cracks alike: the width is within two " +
                "deviations at width " + std::to_string(width) + ", depth " +
                std::to_string(depth) + ", blur " + std::to_string(blur));
      }
  }



  /** Soft cracks of an image whose grain is sharp are soft themselves. */
  void
  check_sharp_surface()
  {
    const StraightScene scene = straight_scene(910000U, false);
    check(sharpest_edges(scene.grey) < -0.5, "grain of a lens in focus");
    check(!segment(scene.grey).cracks.blur.is_measured,
          "an image with sharp grain is in focus");
    cv::Mat noise(300, 300, CV_32F);
    cv::RNG(1).fill(noise, cv::RNG::NORMAL, 120., 4.);
    check(std::isinf(sharpest_edges(noise)), "noise has no edges");
  }
} // namespace



int
main()
{
  cv::setNumThreads(1);
  for (const double width : {1., 3., 5.})
    for (const double blur : {0., 0.35, 0.7, 2., 3.})
      if (width > 1. || blur < 3.)
        {
          check_width(width, blur, 5);
          if (width == 3.)
            check_width(width, blur, 1);
        }
  for (const double width : {1., 2., 3., 4., 6.})
    for (const double depth : {0.57, 0.75})
      for (const double blur : {0.35, 0.7})
        check_cracks_alike(width, depth, blur);
  check_sharp_surface();
  return 0;
}
