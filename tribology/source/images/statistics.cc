// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/tribology/images/centre_line.h>
#include <squeal/tribology/images/line_length.h>
#include <squeal/tribology/images/statistics.h>

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>

namespace squeal::tribology
{
  namespace
  {
    constexpr double length_error = 0.02; // relative, of pixel_lengths()
    // Relative, of what a finder makes of a crack: root mean square over made
    // specimens of three resolutions (ends, short branches, bridges).
    constexpr double finder_error = 0.055;
    constexpr double end_error    = 1.; // pixels, of each free end
    constexpr double missed_width = 2.; // pixels
    // Cracks shorter than 14 pixels are not looked for; the root mean square of
    // what is anything up to that.
    constexpr double too_short   = 14. / 1.7321; // pixels
    constexpr double doubt_error = 0.8; // of what may be missed, invented



    /** Deviation of the length, pixels: of the smoothed line, of its ends, and
     * of the finder, by what it expects to have missed and invented. */
    double
    error_of_length(const cv::Mat     &line,
                    const cv::Mat     &lengths,
                    const FinderDoubt &doubt)
    {
      double length = 0., n_ends = 0.;
      for (const LinePiece &crack : line_pieces(line))
        {
          double own = 0.;
          for (const cv::Point &p : crack.pixels)
            {
              own += lengths.at<float>(p);
              n_ends += n_neighbours(line, p) == 1;
            }
          length += own;
        }
      const double relative = doubt.is_drawn ? length_error : finder_error;
      return std::sqrt(
        std::pow(relative * length, 2) + std::pow(end_error, 2) * n_ends +
        (doubt.is_drawn ? 0. : std::pow(too_short, 2)) +
        std::pow(doubt.unsettled, 2) + std::pow(doubt_error * doubt.missed, 2) +
        std::pow(doubt_error * doubt.invented, 2));
    }



    /** Deviation of the area, pixels: widths are wrong together along a crack,
     * in part in the whole image, and so are lengths. */
    double
    error_of_area(const CrackMap &cracks,
                  const cv::Mat  &lengths,
                  const double    length_part)
    {
      double common = 0., square = 0., area = 0.;
      for (const LinePiece &crack : line_pieces(cracks.centre_line))
        {
          double own = 0.;
          for (const cv::Point &p : crack.pixels)
            {
              const double l = lengths.at<float>(p);
              own += l * cracks.width_error.at<float>(p);
              common += l * cracks.common_width_error.at<float>(p);
              area += l * cracks.width.at<float>(p);
            }
          square += own * own;
        }
      return std::sqrt(square + common * common +
                       std::pow(length_part * area, 2));
    }



    std::vector<double>
    scaled(std::vector<double> values, const double factor)
    {
      for (double &v : values)
        v *= factor;
      return values;
    }



    /** What a placement makes of a pixel: its edges on the pad, um. */
    struct PixelOnPad
    {
      cv::Point2d u, v;

      PixelOnPad(const Placement &placement, const cv::Point2d &p)
      {
        const cv::Point2d o = placement(p);
        u                   = placement(p + cv::Point2d(1., 0.)) - o;
        v                   = placement(p + cv::Point2d(0., 1.)) - o;
      }

      double
      area() const
      {
        return std::abs(u.cross(v));
      }

      /** Of a step of one pixel in a direction of the image. */
      cv::Point2d
      step(const double direction) const
      {
        return std::cos(direction) * u + std::sin(direction) * v;
      }
    };
  } // namespace



  SlidingInImage
  sliding_in_image(const double       on_pad,
                   const Placement   &placement,
                   const cv::Point2d &middle)
  {
    const PixelOnPad  pixel(placement, middle);
    const double      area = pixel.u.cross(pixel.v);
    const cv::Point2d t(std::cos(on_pad), std::sin(on_pad));
    return {std::atan2(pixel.u.cross(t) / area, t.cross(pixel.v) / area),
            area < 0.};
  }



  ImageStatistics
  measure(const Segmentation   &s,
          const double          pixel_size,
          const SlidingInImage &sliding)
  {
    ImageStatistics r;
    const cv::Mat  &line  = s.cracks.centre_line;
    const double    pixel = 1e-6 * pixel_size * pixel_size; // mm^2
    r.observed_area       = pixel * double(line.total());
    cv::Mat1i labels;
    r.n_cracks = cv::connectedComponents(line, labels, 8) - 1;
    r.orientation.assign(ImageStatistics::n_orientations, 0.);
    const cv::Mat lengths = pixel_lengths(line);
    PixelPath     pixels;
    cv::findNonZero(line, pixels);
    double length = 0., weighted_width = 0.;
    for (const cv::Point &p : pixels)
      {
        const double l = lengths.at<float>(p);
        double       a = s.cracks.direction.at<float>(p) - sliding.direction;
        if (sliding.is_mirrored)
          a = -a;
        a -= CV_PI * std::floor(a / CV_PI);
        const int bin =
          std::min(ImageStatistics::n_orientations - 1,
                   int(a / CV_PI * ImageStatistics::n_orientations));
        r.orientation[bin] += l;
        length += l;
        weighted_width += l * s.cracks.width.at<float>(p);
      }
    const double deviation = error_of_length(line, lengths, s.cracks.doubt);
    r.crack_length_error   = 1e-3 * deviation * pixel_size;
    // Of what was missed the width is not known: that of the narrowest lines.
    r.crack_area_error = pixel * missed_width * deviation;
    if (length > 0.)
      {
        r.orientation = scaled(r.orientation, 1. / length);
        r.crack_width = weighted_width / length * pixel_size;
        const double area_deviation =
          error_of_area(s.cracks, lengths, deviation / length);
        r.crack_area_error = pixel * area_deviation;
        r.crack_width_error =
          error_of_area(s.cracks, lengths, 0.) / length * pixel_size;
      }
    r.crack_length         = 1e-3 * length * pixel_size;
    r.crack_density        = r.crack_length / r.observed_area;
    r.crack_area           = pixel * weighted_width;
    const double total     = double(line.total());
    r.exfoliation_fraction = cv::countNonZero(s.areas.exfoliation) / total;
    r.plateau_fraction     = cv::countNonZero(s.areas.plateau) / total;
    r.exfoliation_fraction_error = s.areas.exfoliation_error / total;
    r.plateau_fraction_error     = s.areas.plateau_error / total;
    r.unsettled_fraction         = s.areas.unsettled.empty()
                                     ? 0.
                                     : cv::countNonZero(s.areas.unsettled) / total;
    const double um2             = pixel_size * pixel_size;
    r.exfoliation_areas          = scaled(part_areas(s.areas.exfoliation), um2);
    r.plateau_areas              = scaled(part_areas(s.areas.plateau), um2);
    return r;
  }



  CellGrid::CellGrid(const cv::Size2d &size, const int n_x, const int n_y)
    : size(size)
    , n_x(n_x)
    , n_y(n_y)
    , cells(std::size_t(n_x) * n_y)
    , views(n_y * parts_of_a_cell, n_x * parts_of_a_cell, 0.f)
  {
  }



  int
  CellGrid::index(const cv::Point2d &p) const
  {
    const int i = int(std::floor((p.x / size.width + 0.5) * n_x));
    const int j = int(std::floor((p.y / size.height + 0.5) * n_y));
    return i < 0 || j < 0 || i >= n_x || j >= n_y ? -1 : j * n_x + i;
  }



  void
  CellGrid::add(const Segmentation &s,
                const Placement    &placement,
                const double        sliding)
  {
    const cv::Mat &line    = s.cracks.centre_line;
    const cv::Mat  lengths = pixel_lengths(line);
    note_view(line.size(), placement);
    for (int y = 0; y < line.rows; ++y)
      for (int x = 0; x < line.cols; ++x)
        {
          const int i = index(placement(cv::Point2d(x + 0.5, y + 0.5)));
          if (i < 0)
            continue;
          Cell            &cell = cells[i];
          const PixelOnPad pixel(placement, cv::Point2d(x, y));
          const double     area = pixel.area();
          cell.area += area;
          cell.exfoliation += s.areas.exfoliation.at<uchar>(y, x) ? area : 0.;
          cell.plateau += s.areas.plateau.at<uchar>(y, x) ? area : 0.;
          if (line.at<uchar>(y, x) == 0)
            continue;
          // Along the crack by that direction, across it by what is left of
          // the area.
          const cv::Point2d step =
            pixel.step(s.cracks.direction.at<float>(y, x));
          const double along  = cv::norm(step);
          const double length = lengths.at<float>(y, x) * along;
          const double angle  = 2. * (std::atan2(step.y, step.x) - sliding);
          cell.crack_length += length;
          cell.crack_width +=
            length * area / along * s.cracks.width.at<float>(y, x);
          cell.cosine += length * std::cos(angle);
          cell.sine += length * std::sin(angle);
        }
  }



  void
  CellGrid::note_view(const cv::Size &size_of_image, const Placement &placement)
  {
    const double             w = size_of_image.width, h = size_of_image.height;
    std::vector<cv::Point2d> corners;
    for (const cv::Point2d &c : {cv::Point2d(0., 0.),
                                 cv::Point2d(w, 0.),
                                 cv::Point2d(w, h),
                                 cv::Point2d(0., h)})
      {
        const cv::Point2d p = placement(c);
        corners.emplace_back((p.x / size.width + 0.5) * views.cols,
                             (p.y / size.height + 0.5) * views.rows);
      }
    // Parts whose middles lie in the view, row by row.
    for (int y = 0; y < views.rows; ++y)
      {
        double left = 1e300, right = -1e300;
        for (int k = 0; k < 4; ++k)
          {
            const cv::Point2d from = corners[k], to = corners[(k + 1) % 4];
            if ((from.y > y + 0.5) == (to.y > y + 0.5))
              continue;
            const double x =
              from.x + (y + 0.5 - from.y) / (to.y - from.y) * (to.x - from.x);
            left  = std::min(left, x);
            right = std::max(right, x);
          }
        const double first = std::clamp(left - 0.5, 0., double(views.cols));
        for (int x = int(std::ceil(first)); x < views.cols && x + 0.5 < right;
             ++x)
          views(y, x) += 1.f;
      }
  }

  double
  CellGrid::share_seen_once(const int i, const int j) const
  {
    const cv::Mat part = views(cv::Rect(i * parts_of_a_cell,
                                        j * parts_of_a_cell,
                                        parts_of_a_cell,
                                        parts_of_a_cell));
    const double  sum  = cv::sum(part)[0];
    return sum > 0. ? cv::countNonZero(part) / sum : 1.;
  }



  void
  CellGrid::add_covariate(const std::string &name,
                          const cv::Mat     &values,
                          const Placement   &placement)
  {
    Covariate c{name,
                std::vector<double>(cells.size(), 0.),
                std::vector<double>(cells.size(), 0.)};
    for (int y = 0; y < values.rows; ++y)
      for (int x = 0; x < values.cols; ++x)
        {
          const int i = index(placement(cv::Point2d(x + 0.5, y + 0.5)));
          if (i < 0)
            continue;
          c.sum[i] += values.at<float>(y, x);
          c.weight[i] += 1.;
        }
    covariates.push_back(c);
  }



  std::vector<Table::Column>
  CellGrid::columns() const
  {
    using T                           = Table::Type;
    std::vector<Table::Column> result = {
      {"image", T::text, "", "image, or pad when registered"},
      {"cell", T::integer, "", "number of the cell, x fastest"},
      {"x_m", T::real, "m", "centre of the cell"},
      {"y_m", T::real, "m", "centre of the cell"},
      {"coverage",
       T::real,
       "",
       "part of the cell that was observed, at most 1"},
      {"crack_density_per_m", T::real, "1/m", "crack length per area"},
      {"crack_width_m", T::real, "m", "mean width along the length"},
      {"crack_angle_deg",
       T::real,
       "degrees",
       "mean direction against the sliding direction, -90 to 90"},
      {"crack_alignment",
       T::real,
       "",
       "0: every direction alike, 1: all cracks parallel"},
      {"crack_along_sliding",
       T::real,
       "",
       "mean of cos 2a of that angle: 1 along the sliding, -1 across it"},
      {"exfoliation_fraction", T::real, "", "area of exfoliations"},
      {"plateau_fraction", T::real, "", "area of contact plateaus"}};
    for (const Covariate &c : covariates)
      result.push_back({c.name, T::real, "", "mean of the element map"});
    return result;
  }



  void
  CellGrid::append_rows(Table &table, const std::string &image) const
  {
    const squeal::Cell nothing;
    for (int j = 0; j < n_y; ++j)
      for (int i = 0; i < n_x; ++i)
        {
          const std::size_t k    = std::size_t(j) * n_x + i;
          const Cell       &c    = cells[k];
          const bool        seen = c.area > 0., has = c.crack_length > 0.;
          std::vector<squeal::Cell> row = {
            image,
            int(k),
            1e-6 * size.width * ((i + 0.5) / n_x - 0.5),
            1e-6 * size.height * ((j + 0.5) / n_y - 0.5),
            std::min(1.,
                     share_seen_once(i, j) * c.area * n_x * n_y / size.area()),
            seen ? squeal::Cell(1e6 * c.crack_length / c.area) : nothing,
            has ? squeal::Cell(1e-6 * c.crack_width / c.crack_length) : nothing,
            has ? squeal::Cell(90. / CV_PI * std::atan2(c.sine, c.cosine))
                : nothing,
            has ? squeal::Cell(std::hypot(c.sine, c.cosine) / c.crack_length)
                : nothing,
            has ? squeal::Cell(c.cosine / c.crack_length) : nothing,
            seen ? squeal::Cell(c.exfoliation / c.area) : nothing,
            seen ? squeal::Cell(c.plateau / c.area) : nothing};
          for (const Covariate &v : covariates)
            row.push_back(v.weight[k] > 0.
                            ? squeal::Cell(v.sum[k] / v.weight[k])
                            : nothing);
          table.add_row(row);
        }
  }



  cv::Mat
  draw_overlay(const cv::Mat &grey, const Segmentation &s)
  {
    cv::Mat bytes, picture;
    grey.convertTo(bytes, CV_8U);
    cv::cvtColor(bytes, picture, cv::COLOR_GRAY2BGR);
    const auto outline = [&](const cv::Mat &mask, const cv::Scalar &colour) {
      cv::Mat edge;
      cv::morphologyEx(mask, edge, cv::MORPH_GRADIENT, cv::Mat());
      picture.setTo(colour, edge);
    };
    outline(s.areas.plateau, {255, 180, 0});
    outline(s.areas.exfoliation, {255, 0, 255});
    if (!s.areas.unsettled.empty())
      outline(s.areas.unsettled, {128, 128, 128});
    // What was looked at and left out.
    for (const ExcludedLine &line : s.excluded)
      for (const cv::Point &p : line.pixels)
        picture.at<cv::Vec3b>(p) = {0, 255, 255};
    // Semi-transparent, so that the dark line can still be seen.
    cv::Mat red = picture.clone();
    red.setTo(cv::Scalar(0, 0, 255), s.cracks.area);
    cv::addWeighted(picture, 0.4, red, 0.6, 0., picture);
    picture.setTo(cv::Scalar(0, 0, 255), s.cracks.centre_line);
    return picture;
  }
} // namespace squeal::tribology
