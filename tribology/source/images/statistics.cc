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
    // Cracks shorter than 14 pixels are not looked for, and who draws none has
    // not excluded them either; the root mean square of what is anything up to
    // that.
    constexpr double too_short   = 14. / 1.7321; // pixels
    constexpr double doubt_error = 0.8; // of what may be missed, invented



    /** Deviations of a length, pixels. */
    struct LengthError
    {
      double own    = 0.; /**< of this image */
      double common = 0.; /**< to one side in all images of a run */

      double
      all() const
      {
        return std::hypot(own, common);
      }
    };



    /** Of the smoothed line and of the finder, by what it expects to have
     * missed and invented, which one finder does alike in all images; of the
     * ends. */
    LengthError
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
      return {
        std::sqrt(std::pow(end_error, 2) * n_ends + std::pow(doubt.ends, 2)),
        std::sqrt(
          std::pow(relative * length, 2) +
          (doubt.is_drawn && length > 0. ? 0. : std::pow(too_short, 2)) +
          std::pow(doubt.unsettled, 2) +
          std::pow(doubt_error * doubt.missed, 2) +
          std::pow(doubt_error * doubt.invented, 2))};
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



    /** Sums over the pixels of the centre lines. */
    struct LineSums
    {
      double              pixels = 0.; /**< length in the image */
      double              length = 0.; /**< um on the pad */
      double              area = 0.; /**< um^2 on the pad, length times width */
      std::vector<double> orientation; /**< shares of the length */

      LineSums(const CrackMap  &cracks,
               const cv::Mat   &lengths,
               const Placement &placement,
               const double     sliding)
        : orientation(ImageStatistics::n_orientations, 0.)
      {
        PixelPath line;
        cv::findNonZero(cracks.centre_line, line);
        for (const cv::Point &p : line)
          {
            const PixelOnPad  pixel(placement, {p.x + 0.5, p.y + 0.5});
            const cv::Point2d step  = pixel.step(cracks.direction.at<float>(p));
            const double      l     = lengths.at<float>(p);
            const double      along = l * cv::norm(step);
            double            a     = std::atan2(step.y, step.x) - sliding;
            a -= CV_PI * std::floor(a / CV_PI);
            orientation[std::min(
              int(orientation.size()) - 1,
              int(a / CV_PI * double(orientation.size())))] += along;
            pixels += l;
            length += along;
            area += l * pixel.area() * cracks.width.at<float>(p);
          }
        if (length > 0.)
          orientation = scaled(orientation, 1. / length);
      }
    };



    Placement
    of_square_pixels(const double size)
    {
      return {cv::Matx33d(size, 0., 0., 0., size, 0., 0., 0., 1.), 0.};
    }
  } // namespace



  void
  SummedLengthError::add(const ImageStatistics &image)
  {
    common += image.crack_length_common_error;
    square += std::pow(image.crack_length_error, 2) -
              std::pow(image.crack_length_common_error, 2);
  }



  double
  SummedLengthError::deviation(const double share) const
  {
    return std::sqrt(std::pow(share * common, 2) +
                     std::max(0., share * square));
  }



  PixelAreas::PixelAreas(const Segmentation &s, const Placement &placement)
    : of_pixels(s.cracks.centre_line.size())
  {
    for (int y = 0; y < of_pixels.rows; ++y)
      for (int x = 0; x < of_pixels.cols; ++x)
        of_pixels(y, x) = PixelOnPad(placement, {x + 0.5, y + 0.5}).area();
    seen = s.seen.empty() ? cv::sum(of_pixels)[0] : of(s.seen);
  }



  double
  PixelAreas::of(const cv::Mat &mask) const
  {
    double sum = 0.;
    for (int y = 0; y < mask.rows; ++y)
      for (int x = 0; x < mask.cols; ++x)
        sum += mask.at<uchar>(y, x) != 0 ? of_pixels(y, x) : 0.;
    return sum;
  }



  ImageStatistics
  measure(const Segmentation &s, const Placement &placement, double sliding)
  {
    ImageStatistics  r;
    const cv::Mat   &line = s.cracks.centre_line;
    const PixelAreas areas(s, placement);
    const double     n = n_seen(s.seen, line.size());
    r.observed_area    = 1e-6 * areas.seen;
    cv::Mat1i labels;
    r.n_cracks             = cv::connectedComponents(line, labels, 8) - 1;
    const cv::Mat  lengths = pixel_lengths(line);
    const LineSums sums(s.cracks, lengths, placement, sliding);
    r.orientation      = sums.orientation;
    const double pixel = areas.seen / n; // um^2, on the mean
    const double along =
      sums.length > 0. ? sums.length / sums.pixels : std::sqrt(pixel);
    const LengthError error = error_of_length(line, lengths, s.cracks.doubt);
    const double      deviation = error.all();
    r.crack_length_error        = 1e-3 * deviation * along;
    r.crack_length_common_error = 1e-3 * error.common * along;
    // Of what was missed the width is not known: that of the narrowest lines.
    r.crack_area_error = 1e-6 * pixel * missed_width * deviation;
    if (sums.length > 0.)
      {
        r.crack_width = sums.area / sums.length;
        r.crack_area_error =
          1e-6 * pixel *
          error_of_area(s.cracks, lengths, deviation / sums.pixels);
        r.crack_width_error =
          error_of_area(s.cracks, lengths, 0.) / sums.pixels * pixel / along;
      }
    r.crack_length               = 1e-3 * sums.length;
    r.crack_density              = r.crack_length / r.observed_area;
    r.crack_area                 = 1e-6 * sums.area;
    r.exfoliation_fraction       = areas.of(s.areas.exfoliation) / areas.seen;
    r.plateau_fraction           = areas.of(s.areas.plateau) / areas.seen;
    r.exfoliation_fraction_error = s.areas.exfoliation_error / n;
    r.plateau_fraction_error     = s.areas.plateau_error / n;
    r.unsettled_fraction         = areas.of(s.areas.unsettled) / areas.seen;
    r.darker_level_fraction      = s.areas.darker_share;
    r.bulk_is_darker             = s.areas.bulk_is_darker;
    r.exfoliation_areas = part_areas(s.areas.exfoliation, areas.of_pixels);
    r.plateau_areas     = part_areas(s.areas.plateau, areas.of_pixels);
    return r;
  }



  ImageStatistics
  measure(const Segmentation &s, const double pixel_size, const double sliding)
  {
    return measure(s, of_square_pixels(pixel_size), sliding);
  }



  double
  length_on_pad(const PixelPath &line, const Placement &placement)
  {
    const PixelOnPad pixel(placement, line[line.size() / 2]);
    cv::Point2d      mean(0., 0.);
    for (const cv::Point2d p : line)
      mean += p * (1. / double(line.size()));
    double cosine = 0., sine = 0.;
    for (const cv::Point2d p : line)
      {
        const cv::Point2d d = p - mean;
        cosine += d.x * d.x - d.y * d.y;
        sine += 2. * d.x * d.y;
      }
    return length_of_pixels(line) *
           cv::norm(pixel.step(0.5 * std::atan2(sine, cosine)));
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
