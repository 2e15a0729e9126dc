// SPDX-License-Identifier: LGPL-2.1-or-later

// Length and width of lines against closed forms: straight lines, circles, a
// junction, blurred cracks of known width and depth, thin, wide and beside each
// other; cells add up to the total.
#include <squeal/tribology/images/cell_grid.h>
#include <squeal/tribology/images/centre_line.h>
#include <squeal/tribology/images/line_length.h>
#include <squeal/tribology/images/specimen.h>
#include <squeal/tribology/images/statistics.h>

#include <opencv2/imgproc.hpp>

#include <array>
#include <cmath>
#include <cstdio>
#include <utility>
#include <vector>

#include "check.h"
#include "worst.h"

using namespace squeal;
using namespace squeal::testing;
using namespace squeal::tribology;

namespace
{
  /** Sets one pixel for each column or row, whichever the line crosses more
   * of, whose centre lies between the ends. */
  void
  draw(cv::Mat &line, const cv::Point2d &a, const cv::Point2d &b)
  {
    const cv::Point2d d    = b - a;
    const bool        flat = std::abs(d.x) > std::abs(d.y);
    const double      from = flat ? a.x : a.y, to = flat ? b.x : b.y;
    const int         first = int(std::ceil(std::min(from, to)));
    for (int i = first; i <= std::max(from, to); ++i)
      {
        const cv::Point2d p = a + d * ((i - from) / (to - from));
        line.at<uchar>(cvRound(p.y), cvRound(p.x)) = 255;
      }
  }



  cv::Point2d
  unit(const double angle)
  {
    return {std::cos(angle), std::sin(angle)};
  }



  double
  length_of(const cv::Mat &line)
  {
    return cv::sum(pixel_lengths(line))[0];
  }



  /** Mean error over all angles and offsets: what is left of the rounding and
   * what two free ends give. The first grows with the length, the second does
   * not. */
  void
  check_straight_lines()
  {
    cv::RNG   random(5);
    const int n = 1440;
    for (const double length : {10., 20., 40., 80., 160., 320.})
      {
        Worst  largest;
        double mean = 0.;
        for (int i = 0; i < n; ++i)
          {
            cv::Mat           line = cv::Mat::zeros(340, 340, CV_8U);
            const cv::Point2d c(170. + random.uniform(0., 1.),
                                170. + random.uniform(0., 1.));
            const cv::Point2d half = 0.5 * length * unit(i * CV_PI / n);
            draw(line, c - half, c + half);
            const double error = length_of(line) - length;
            mean += error / n;
            largest.add(std::abs(error));
          }
        std::printf("lines of %g px: mean error %.3f px, largest %.2f px\n",
                    length,
                    mean,
                    largest.largest());
        const std::string text =
          " at length " + std::to_string(int(length)) + " px";
        // Order one: 0.04 % of a line of 320 pixels.
        check(std::abs(mean) < 0.12, "mean error below 0.12 px" + text);
        // Ends fall between pixels, up to sqrt(2) px, and are smoothed less. At
        // 7 degrees from an axis
        // the staircase is so long that much of it passes the smoothing.
        check(largest.largest() < 1.6 + 0.008 * length,
              "each error below 1.6 px and 0.8 %" + text);
      }
  }



  /** The mean over the offset is right to second order in pixel over radius. */
  void
  check_circles()
  {
    cv::RNG   random(3);
    const int n      = 20;
    double    coarse = 0., fine = 0.;
    for (const double radius : {8., 10., 20., 40., 80.})
      {
        double mean = 0.;
        for (int i = 0; i < n; ++i)
          {
            cv::Mat           line = cv::Mat::zeros(180, 180, CV_8U);
            const cv::Point2d c(90. + random.uniform(0., 1.),
                                90. + random.uniform(0., 1.));
            for (int k = 0; k < 4000; ++k)
              {
                const cv::Point2d p = c + radius * unit(k * CV_PI / 2000.);
                line.at<uchar>(cvRound(p.y), cvRound(p.x)) = 255;
              }
            mean += length_of(tribology::thin(line)) / n;
          }
        const double error = mean / (2. * CV_PI * radius) - 1.;
        std::printf("circles of %g px: mean error %.5f\n", radius, error);
        check(std::abs(error) < 0.08 / radius,
              "circle within 0.08 px of its radius " +
                std::to_string(int(radius)));
        if (radius == 10.)
          coarse = std::abs(error);
        if (radius == 40.)
          fine = std::abs(error);
      }
    check(std::log(coarse / fine) / std::log(4.) > 1.5,
          "circles: order above 1.5 from radius 10 to 40");
  }



  void
  check_junction()
  {
    double mean = 0.;
    for (int i = 0; i < 60; ++i)
      {
        cv::Mat           line = cv::Mat::zeros(300, 300, CV_8U);
        const cv::Point2d c(150.4, 149.7);
        for (int k = 0; k < 3; ++k)
          draw(line, c, c + 100. * unit((2 * i + 120 * k) * CV_PI / 180.));
        const double ratio = length_of(tribology::thin(line)) / 300.;
        check(std::abs(ratio - 1.) < 0.025,
              "junction of three lines within 2.5 %, turned by " +
                std::to_string(2 * i));
        mean += ratio / 60.;
      }
    std::printf("junctions: mean %.4f\n", mean);
    check(std::abs(mean - 1.) < 0.01, "junctions, mean within 1 %");
    cv::Mat dot         = cv::Mat::zeros(9, 9, CV_8U);
    dot.at<uchar>(4, 4) = 255;
    check(length_of(dot) == 1., "a single pixel is a pixel long");
    check(length_of(cv::Mat::zeros(9, 9, CV_8U)) == 0., "nothing has none");
  }



  /** Straight cracks with vertical walls, blurred by 0.7 pixels and the pixel,
   * at 25 degrees and @p apart from the first one's middle, in @p noise of so
   * many grey levels. Lines are drawn on those of @p drawn. */
  CrackMap
  blurred_cracks(const double               width,
                 const double               depth,
                 const std::vector<double> &apart,
                 const std::vector<double> &drawn,
                 const double               noise,
                 const double               largest_width)
  {
    const cv::Point2d c(150.2, 150.4), along = unit(25. * CV_PI / 180.);
    const double      blur = std::sqrt(0.49 + 1. / 12.) * std::sqrt(2.);
    cv::Mat           grey(300, 300, CV_32F);
    cv::RNG           random(11);
    for (int y = 0; y < grey.rows; ++y)
      for (int x = 0; x < grey.cols; ++x)
        {
          double light = 128.;
          for (const double place : apart)
            {
              const double r = along.cross(cv::Point2d(x, y) - c) - place;
              light *= 1. - 0.5 * depth *
                              (std::erf((r + 0.5 * width) / blur) -
                               std::erf((r - 0.5 * width) / blur));
            }
          grey.at<float>(y, x) = float(light + random.gaussian(noise));
        }
    cv::Mat           line = cv::Mat::zeros(grey.size(), CV_8U);
    const cv::Point2d across(-along.y, along.x);
    for (const double place : drawn)
      draw(line,
           c + place * across - 90. * along,
           c + place * across + 90. * along);
    return measure_cracks(grey, line, filter_ridges(grey, 2), largest_width);
  }

  CrackMap
  blurred_crack(const double width, const double depth)
  {
    return blurred_cracks(width, depth, {0.}, {0.}, 0., 9.);
  }

  /** Mean width and its deviation. */
  std::array<double, 2>
  width_of(const CrackMap &m)
  {
    const double n = cv::countNonZero(m.centre_line);
    return {{cv::sum(m.width)[0] / n,
             std::hypot(cv::sum(m.width_error)[0] / n,
                        cv::sum(m.common_width_error)[0] / n)}};
  }



  /** What errs to one side in every image adds up over images, where single
   * lines end does not; the same image many times is as sure as once. */
  void
  check_summed_lengths()
  {
    ImageStatistics image;
    image.crack_length_error        = 0.5;
    image.crack_length_common_error = 0.4;
    const auto sum = [&image](const int n, const double share) {
      SummedLengthError errors;
      for (int i = 0; i < n; ++i)
        errors.add(image);
      return errors.deviation(share);
    };
    check_close(sum(1, 1.), 0.5, 1e-12, "of one image");
    check_close(
      sum(16, 1.), std::hypot(16. * 0.4, 4. * 0.3), 1e-12, "of sixteen");
    check_close(sum(16, 1. / 16.), 0.5, 1e-12, "of one image sixteen times");
    const ImageStatistics measured =
      measure(segment(cv::Mat(64, 64, CV_32F, cv::Scalar(100.))), 1., 0.);
    check_close(measured.crack_length_common_error,
                measured.crack_length_error,
                1e-12,
                "what is missed where nothing is found is missed everywhere");
  }



  void
  check_widths()
  {
    for (const double depth : {0.45, 0.57, 0.7})
      for (const double width : {0.5, 1., 2., 3., 4., 6., 8.})
        {
          const CrackMap m          = blurred_crack(width, depth);
          const auto [found, error] = width_of(m);
          std::printf("width %.1f depth %.2f: %.3f +- %.3f\n",
                      width,
                      depth,
                      found,
                      error);
          const std::string text = " at width " + std::to_string(width) +
                                   ", depth " + std::to_string(depth);
          check(std::abs(found - width) <= 2. * error,
                "within two deviations" + text);
          if (depth == 0.57)
            check(std::abs(found / width - 1.) < 0.1,
                  "within 10 % where the depth is the assumed one" + text);
          if (width >= 6.)
            check(std::abs(found / width - 1.) < 0.05,
                  "wide cracks show their depth" + text);
        }
  }



  /** Faint cracks, one and three of them in noise: where depth and width are
   * not told apart the deviation contains what may be. */
  void
  check_faint_cracks()
  {
    for (const double depth : {0.1, 0.12, 0.15, 0.2, 0.25, 0.3, 0.35})
      for (const double width : {2., 3., 4., 6., 8.})
        for (const std::vector<double> &places :
             {std::vector<double>{0.}, std::vector<double>{0., 50., -50.}})
          {
            const double noise = places.size() > 1 ? 2. : 0.;
            const auto [found, error] =
              width_of(blurred_cracks(width, depth, places, places, noise, 9.));
            std::printf("width %.1f depth %.2f, %zu: %.3f +- %.3f\n",
                        width,
                        depth,
                        places.size(),
                        found,
                        error);
            const std::string text = " at width " + std::to_string(width) +
                                     ", depth " + std::to_string(depth);
            check(std::abs(found - width) <= 2. * error,
                  "faint cracks within two deviations" + text);
            if (width >= 6.)
              check(std::abs(found / width - 1.) < 0.15,
                    "wide faint cracks show their depth" + text);
          }
  }



  /** Bands that no profile of a pixel reaches over, and a line on nothing. */
  void
  check_wide_cracks()
  {
    for (const double width : {12., 15., 18., 23., 35., 51., 90.})
      {
        const auto [found, error] =
          width_of(blurred_cracks(width, 0.6, {0.}, {0.}, 3., 144.));
        std::printf("wide %g: %.2f +- %.2f\n", width, found, error);
        const std::string text = " at width " + std::to_string(int(width));
        check_close(found, width, 0.05 * width, "wide crack" + text);
        check(std::abs(found - width) <= 2. * error,
              "within two deviations" + text);
      }
    // Without the wider ones a thin one is what it was.
    const auto thin = width_of(blurred_cracks(3., 0.6, {0.}, {0.}, 3., 9.)),
               same = width_of(blurred_cracks(3., 0.6, {0.}, {0.}, 3., 144.));
    check(thin == same, "a thin crack beside what may be wide is the same");
    const CrackMap none = blurred_cracks(3., 0., {0.}, {0.}, 3., 144.);
    check(none.without_line == cv::countNonZero(none.centre_line) &&
            width_of(none)[1] >= 144.,
          "where no line is dark any width may be");
  }



  /** Flanks between two cracks, and beside one that nobody drew. */
  void
  check_parallel_cracks()
  {
    for (const auto &[width, apart] : {std::pair(3., 8.),
                                       std::pair(3., 10.),
                                       std::pair(5., 10.),
                                       std::pair(9., 16.),
                                       std::pair(3., 14.)})
      for (const double last : {apart, 0.})
        {
          std::vector<double> drawn = {0.};
          if (last > 0.)
            drawn.push_back(last);
          const auto [found, error] =
            width_of(blurred_cracks(width, 0.6, {0., apart}, drawn, 2., 144.));
          std::printf("width %g, %g apart, %zu drawn: %.2f +- %.2f\n",
                      width,
                      apart,
                      drawn.size(),
                      found,
                      error);
          const std::string text = " at width " + std::to_string(int(width)) +
                                   ", " + std::to_string(int(apart)) + " apart";
          check_close(found, width, 0.15 * width, "parallel cracks" + text);
          check(std::abs(found - width) <= 2. * error,
                "within two deviations" + text);
        }
    const auto [found, error] =
      width_of(blurred_cracks(9., 0.6, {0., 16., -16.}, {0.}, 2., 144.));
    check(std::abs(found - 9.) <= 2. * error, "one between two others");
  }



  void
  check_cells()
  {
    SpecimenSettings settings;
    settings.data_bar   = false;
    const Specimen made = make_specimen(settings);
    cv::Mat        grey;
    made.image.convertTo(grey, CV_32F);
    const Segmentation    found = segment(grey);
    const ImageStatistics s     = measure(found, 1., {});
    // cells of whole pixels from a corner of the image on; the last ones reach
    // beyond it
    const cv::Size2d size(5. * std::ceil(grey.cols / 5.),
                          4. * std::ceil(grey.rows / 4.));
    CellGrid         grid(size, 5, 4);
    const Placement  placement{
      cv::Matx33d(
        1., 0., -0.5 * size.width, 0., 1., -0.5 * size.height, 0., 0., 1.),
      0.};
    grid.add(found, placement, 0.);
    Table table(grid.columns());
    grid.append_rows(table, "image");
    const double cell   = 1e-12 * size.area() / 20.; // m^2
    double       length = 0., area = 0.;
    for (std::size_t i = 0; i < table.n_rows(); ++i)
      {
        const double l = table.real(i, "crack_density_per_m") * cell *
                         table.real(i, "coverage");
        length += l;
        area += l > 0. ? l * table.real(i, "crack_width_m") : 0.;
      }
    Worst coverage;
    for (const double part : table.reals("coverage"))
      coverage.add(part);
    check(coverage.largest() == 1. && coverage.smallest() > .9,
          "cells within the image are covered, none more than that");
    check_close(1e3 * length, s.crack_length, 1e-5, "length of all cells");
    check_close(1e6 * area, s.crack_area, 1e-5, "area of all cells");
    grid.add(found, placement, 0.);
    Table twice(grid.columns());
    grid.append_rows(twice, "image");
    Worst again, change;
    for (std::size_t i = 0; i < table.n_rows(); ++i)
      {
        again.add(twice.real(i, "coverage"));
        change.add(std::abs(twice.real(i, "crack_density_per_m") -
                            table.real(i, "crack_density_per_m")));
      }
    check(again.largest() == 1. && change.is_within(1e-6),
          "an image that is seen twice covers a cell once");
    check(std::abs(s.crack_length - 1e-3 * made.crack_length) <
            2. * s.crack_length_error,
          "length within two deviations of the true one");
    check(std::abs(s.crack_area - 1e-6 * made.crack_area) <
            2. * s.crack_area_error,
          "area within two deviations of the true one");
    check(s.crack_length_error < 0.25 * s.crack_length &&
            s.crack_area_error < 0.3 * s.crack_area,
          "deviations below 25 % of the length and 30 % of the area");
  }
} // namespace



int
main()
{
  cv::setNumThreads(1);
  check_straight_lines();
  check_circles();
  check_junction();
  check_summed_lengths();
  check_widths();
  check_faint_cracks();
  check_wide_cracks();
  check_parallel_cracks();
  check_cells();
  return 0;
}
