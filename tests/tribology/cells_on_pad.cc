// SPDX-License-Identifier: LGPL-2.1-or-later

// Cells of a pad have what lies on the pad, however an image shows it: lengths,
// widths and directions of lines through stretched, turned and mirrored
// placements, and parts that several images show only once.
#include <squeal/tribology/driver/image_report.h>
#include <squeal/tribology/history/contact_grid.h>
#include <squeal/tribology/images/cell_grid.h>
#include <squeal/tribology/images/line_length.h>
#include <squeal/tribology/images/micrograph.h>
#include <squeal/tribology/images/statistics.h>
#include <squeal/tribology/statistics/association.h>

#include <opencv2/imgproc.hpp>

#include <cmath>

#include "check.h"
#include "worst.h"

using namespace squeal;
using namespace squeal::testing;
using namespace squeal::tribology;

namespace
{
  constexpr int width = 200, height = 160;

  /** A line 3 pixels wide between two points. */
  Segmentation
  drawn(const cv::Point &from, const cv::Point &to)
  {
    Segmentation s;
    s.cracks.centre_line = cv::Mat::zeros(height, width, CV_8U);
    cv::line(s.cracks.centre_line, from, to, 255, 1);
    s.cracks.width       = cv::Mat(height, width, CV_32F, cv::Scalar(3.));
    s.cracks.width_error = cv::Mat::zeros(height, width, CV_32F);
    s.cracks.common_width_error = s.cracks.width_error.clone();
    const cv::Point step        = to - from;
    const double    angle       = std::atan2(double(step.y), double(step.x));
    s.cracks.direction          = cv::Mat(
      height, width, CV_32F, cv::Scalar(angle < 0. ? angle + CV_PI : angle));
    s.areas.exfoliation = s.areas.plateau =
      cv::Mat::zeros(height, width, CV_8U);
    return s;
  }

  /** The only cell of a pad of 2 x 2 mm, to which @p matrix takes pixels. */
  Table
  cell_of(const Segmentation &s,
          const cv::Matx33d  &matrix,
          const double        sliding = 0.)
  {
    CellGrid grid({2000., 2000.}, 1, 1);
    grid.add(s, {matrix, 0.}, sliding);
    Table table(grid.columns());
    grid.append_rows(table, "pad");
    return table;
  }

  double
  length_on(const Table &cell) // um
  {
    return 1e6 * cell.real(0, "crack_density_per_m") * 4e-6 *
           cell.real(0, "coverage");
  }

  void
  check_stretched()
  {
    // 1.5 um a pixel along x, 1/1.5 along y.
    const cv::Matx33d stretch(1.5, 0., -150., 0., 1. / 1.5, -50., 0., 0., 1.);
    const Table       along = cell_of(drawn({30, 80}, {150, 80}), stretch),
                across      = cell_of(drawn({80, 20}, {80, 140}), stretch);
    check_close(length_on(along), 1.5 * 121., 0.01, "length along x");
    check_close(length_on(across), 121. / 1.5, 0.01, "length along y");
    check_close(along.real(0, "crack_width_m"), 2e-6, 1e-6, "width across it");
    check_close(
      across.real(0, "crack_width_m"), 4.5e-6, 1e-6, "width of the other");
    const Table slanting = cell_of(drawn({40, 30}, {120, 110}), stretch);
    check_close(slanting.real(0, "crack_angle_deg"),
                std::atan(1. / 2.25) * 180. / CV_PI,
                1e-5,
                "direction on the pad");
  }

  void
  check_turned()
  {
    const auto        line = drawn({40, 30}, {120, 76});
    const double      a    = std::atan2(46., 80.);
    const cv::Matx33d upright(1., 0., -100., 0., 1., -80., 0., 0., 1.);
    const Table       alone = cell_of(line, upright);
    check_close(alone.real(0, "crack_angle_deg"),
                a * 180. / CV_PI,
                1e-5,
                "direction of an upright image");
    check_close(alone.real(0, "crack_along_sliding"),
                std::cos(2. * a),
                1e-5,
                "and its part along the sliding");
    // The same line of the pad in a mirrored and in a turned image.
    const Table mirrored =
      cell_of(drawn({40, height - 1 - 30}, {120, height - 1 - 76}),
              {1., 0., -100., 0., -1., height - 1. - 80., 0., 0., 1.});
    const Table turned =
      cell_of(drawn({height - 1 - 30, 40}, {height - 1 - 76, 120}),
              {0., 1., -100., -1., 0., height - 1. - 80., 0., 0., 1.});
    for (const auto &[other, name] :
         {std::pair(&mirrored, "mirrored"), std::pair(&turned, "turned")})
      check_close(other->real(0, "crack_angle_deg"),
                  alone.real(0, "crack_angle_deg"),
                  1e-4,
                  std::string("the same direction of a ") + name + " image");
    // And over a whole image, where bins begin with the sliding direction.
    for (const double sliding : {0.3, 1.2})
      {
        const Placement straight{upright, 0.},
          flipped{{1., 0., -100., 0., -1., 79., 0., 0., 1.}, 0.};
        const auto a_bins = measure(line, straight, sliding).orientation,
                   b_bins = measure(drawn({40, height - 1 - 30},
                                          {120, height - 1 - 76}),
                                    flipped,
                                    sliding)
                              .orientation;
        check(a_bins == b_bins, "the same bins of a mirrored image");
        check(a_bins != measure(line, straight, 0.).orientation,
              "which the sliding direction moves");
      }
  }

  /** Figures of a whole image are those of its cells where pixels are no
   * squares. */
  void
  check_stretched_pixels()
  {
    for (const cv::Point &to : {cv::Point(40, 130), cv::Point(140, 30)})
      {
        const auto            line = drawn({40, 30}, to);
        const cv::Matx33d     tall(1., 0., -100., 0., 2., -160., 0., 0., 1.);
        const ImageStatistics s = measure(line, {tall, 0.}, 0.),
                              r = measure(line, std::sqrt(2.), 0.);
        const Table cell        = cell_of(line, tall);
        const bool  is_upright  = to.x == 40;
        check_close(s.crack_length / r.crack_length,
                    is_upright ? std::sqrt(2.) : std::sqrt(0.5),
                    1e-6,
                    "length along the longer or the shorter edge");
        check_close(s.crack_width / r.crack_width,
                    is_upright ? std::sqrt(0.5) : std::sqrt(2.),
                    1e-6,
                    "width across it");
        check_close(s.crack_area, r.crack_area, 1e-6, "the same area");
        check_close(1e3 * s.crack_length,
                    1e-6 * cell.real(0, "crack_density_per_m") * 1e6 *
                      s.observed_area,
                    1e-6,
                    "as in the cells");
        check_close(s.crack_length_error / s.crack_length,
                    r.crack_length_error / r.crack_length,
                    1e-6,
                    "with the same relative error");
      }
  }

  /** The mean of an element map is by area on the pad. The map of the place
   * along x over an image that is narrower at its right edge: x of the centroid
   * of the trapezoid. */
  void
  check_covariate_by_area()
  {
    const double      bend = 4e-3;
    const cv::Matx33d matrix(1., 0., -80., 0., 1., -80., bend, 0., 1.);
    const Placement   placement{matrix, 0.};
    cv::Mat           along(height, width, CV_32F);
    for (int x = 0; x < width; ++x)
      along.col(x).setTo(placement({x + .5, .5}).x);
    CellGrid grid({2000., 2000.}, 1, 1);
    grid.add(drawn({40, 30}, {120, 76}), placement, 0.);
    grid.add_covariate("along", along, placement);
    Table table(grid.columns());
    grid.append_rows(table, "pad");
    const double left = placement({0., 0.}).x,
                 base = placement({double(width), 0.}).x - left,
                 edge = 1. / (1. + bend * width); // over the left one
    check_close(table.real(0, "along") - left,
                base * (1. + 2. * edge) / (3. * (1. + edge)),
                1e-4,
                "mean of an element map");
  }

  void
  check_overlap()
  {
    // Both over the left half of the cell; the second also further down.
    const auto        line = drawn({40, 30}, {120, 76});
    const cv::Matx33d left(5., 0., -1000., 0., 12.5, -1000., 0., 0., 1.);
    CellGrid          grid({2000., 2000.}, 1, 1);
    for (unsigned int times = 1; times <= 3; ++times)
      {
        grid.add(line, {left, 0.}, 0.);
        Table table(grid.columns());
        grid.append_rows(table, "pad");
        check_close(table.real(0, "coverage"),
                    0.5,
                    1e-9,
                    "half a cell is half a cell, however often it is seen");
        const CellGrid::SeenOnce once = grid.seen_once();
        check_close(once.share, 1. / times, 1e-9, "of all that images show");
        check_close(once.crack_length,
                    1e3 * measure(line, {left, 0.}, 0.).crack_length,
                    1e-9,
                    "the length of the crack counts once");
      }
    grid.add(line, {{5., 0., 0., 0., 12.5, -1000., 0., 0., 1.}, 0.}, 0.);
    Table table(grid.columns());
    grid.append_rows(table, "pad");
    check_close(table.real(0, "coverage"), 1., 1e-9, "and both halves are one");
  }

  /** Two images of 200 um that share 100 um of a cell: a crack, an exfoliation
   * and a plateau count once, in the part that both show and beside it. */
  void
  check_part_of_overlap()
  {
    const auto seen_from = [](const cv::Point &corner, const int x) {
      Segmentation s = drawn({x - corner.x, 20}, {x - corner.x, 140});
      if (!cv::Rect(0, 0, width, height).contains({x - corner.x, 20}))
        s.cracks.centre_line.setTo(0);
      const cv::Rect area =
        (cv::Rect(x + 10, 30, 40, 50) - corner) & cv::Rect(0, 0, width, height);
      s.areas.exfoliation(area).setTo(255);
      s.areas.plateau(area).setTo(255);
      return s;
    };
    const auto at = [](const cv::Point &corner) {
      return Placement{{1., 0., corner.x - 150., 0., 1., -80., 0., 0., 1.}, 0.};
    };
    for (const int x : {40, 130, 240})
      for (const bool swapped : {false, true})
        {
          CellGrid grid({300., 160.}, 1, 1);
          for (const int i : {0, 1})
            {
              const cv::Point corner((i == 1) != swapped ? 100 : 0, 0);
              grid.add(seen_from(corner, x), at(corner), 0.);
            }
          Table table(grid.columns());
          grid.append_rows(table, "pad");
          const std::string name =
            "a crack at " + std::to_string(x) + " um: its ";
          check_close(
            grid.seen_once().crack_length, 121., 0.01, name + "length");
          check_close(grid.seen_once().share, 0.75, 1e-9, "and what is seen");
          check_close(table.real(0, "crack_density_per_m"),
                      1e6 * 121. / (300. * 160.),
                      0.01,
                      name + "density");
          check_close(table.real(0, "crack_along_sliding"),
                      -1.,
                      1e-6,
                      name + "direction");
          for (const char *column :
               {"exfoliation_fraction", "plateau_fraction"})
            check_close(table.real(0, column),
                        40. * 50. / (300. * 160.),
                        1e-9,
                        name + column);
        }
  }

  /** The headline of images that overlap is that of one of them. */
  void
  check_headline()
  {
    SegmentationRecord record;
    record.images.resize(1);
    record.images[0].statistics.crack_length       = 2.01;
    record.images[0].statistics.crack_length_error = 0.1;
    record.images[0].statistics.observed_area      = 0.5;
    const std::string one                          = cracks_in_words(record);
    check(one.find("cracks of 2.01 +- 0.1") == 0 &&
            one.find(", 4.02 mm per mm^2") != std::string::npos,
          "one image: " + one);
    record.images.push_back(record.images[0]);
    check(cracks_in_words(record).find("cracks of 4.02 +- 0.14") == 0,
          "two places add up: " + cracks_in_words(record));
    record.seen_once       = {5e5, 2010., 0.5};
    const std::string same = cracks_in_words(record);
    check(same.find("cracks of 2.01 +- 0.1") == 0 &&
            same.find(", 4.02 mm per mm^2") != std::string::npos &&
            same.find("overlap") != std::string::npos,
          "one place twice does not: " + same);
  }

  void
  check_lines_of_pixels()
  {
    std::vector<cv::Point> diagonal;
    for (int i = 0; i <= 140; ++i)
      diagonal.emplace_back(60 + i, i);
    check_close(length_of_pixels(diagonal),
                141. * std::sqrt(2.),
                0.01,
                "a line along a diagonal");
  }

  /** Rows that are saturated by a half are picture, an even strip with a text
   * is a data bar. */
  void
  check_data_bars()
  {
    cv::Mat grey(400, 640, CV_32F);
    cv::RNG(3).fill(grey, cv::RNG::UNIFORM, 40., 200.);
    cv::Mat saturated = grey.clone();
    saturated(cv::Rect(0, 330, 352, 70)).setTo(255.);
    check(rows_above_data_bar(saturated) == 400, "saturated rows are picture");
    cv::Mat bar = grey.clone();
    bar.rowRange(350, 400).setTo(0.);
    bar.rowRange(350, 352).setTo(255.);
    cv::putText(bar, "20 kV  100 um", {40, 385}, 0, 1., 255., 2);
    check(rows_above_data_bar(bar) == 350, "an even strip is a data bar");
    bar.rowRange(398, 400).setTo(255.);
    check(rows_above_data_bar(bar) == 350, "and so is one with a frame");
  }

  /** Points that are middles of cells have cells of their whole area. */
  void
  check_middles_of_cells()
  {
    for (const bool middles : {true, false})
      {
        std::vector<std::array<double, 3>> points;
        std::vector<double>                areas;
        const double                       first = middles ? -4e-3 : -5e-3,
                     step                        = middles ? 2e-3 : 2.5e-3;
        for (int j = 0; j < 5; ++j)
          for (int i = 0; i < 5; ++i)
            {
              points.push_back({{first + step * i, first + step * j, 0.}});
              const bool x_end = i % 4 == 0, y_end = j % 4 == 0;
              areas.push_back(step * step * (middles || !x_end ? 1. : .5) *
                              (middles || !y_end ? 1. : .5));
            }
        const ContactGrid grid(points, areas);
        Worst             difference;
        for (std::size_t k = 0; k < points.size(); ++k)
          {
            const Patch &c = grid.cell(k);
            difference.add(std::abs(
              (c.x_max - c.x_min) * (c.y_max - c.y_min) / areas[k] - 1.));
          }
        check_within(difference,
                     1e-9,
                     std::string("cells have their areas about ") +
                       (middles ? "middles" : "nodes"));
        check(std::abs(grid.face().x_max - 5e-3) < 1e-12 &&
                std::abs(grid.face().y_min + 5e-3) < 1e-12,
              "the face is the whole face");
      }
  }

  void
  check_constants()
  {
    std::vector<double> one(121, 0.1), third(121, 1. / 3.), wave;
    for (int i = 0; i < 121; ++i)
      wave.push_back(std::sin(1.3 * i));
    check(std::isnan(pearson(one, third)) && std::isnan(pearson(wave, one)),
          "a constant has no correlation");
    std::vector<double> small;
    for (const double w : wave)
      small.push_back(1. + 1e-9 * w);
    check_close(pearson(small, wave), 1., 1e-6, "a small variation has one");
  }
} // namespace



int
main()
{
  check_stretched();
  check_turned();
  check_stretched_pixels();
  check_covariate_by_area();
  check_overlap();
  check_part_of_overlap();
  check_headline();
  check_lines_of_pixels();
  check_data_bars();
  check_middles_of_cells();
  check_constants();
}
