// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/tribology/images/centre_line.h>
#include <squeal/tribology/images/crack_depth.h>
#include <squeal/tribology/images/crack_finder.h>
#include <squeal/tribology/images/crack_profiles.h>
#include <squeal/tribology/images/image_blur.h>

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>

namespace squeal::tribology
{
  namespace
  {
    constexpr double rounding = 1. / 12.; // pixels^2, of a skeleton
    // A gap of a line, pixels, beside a line that is as dark as its darker
    // quarter within that distance.
    constexpr int         beside_gap   = 25; // pixels
    constexpr std::size_t shortest_gap = 6;
    constexpr float       light_in_gap = 1.F / 3.F; // of the darkness beside
    // Pixels of a crack that tells its shape, and a variance that no edge out
    // of focus has, pixels^2: lines narrower than the Gaussian that tells it.
    constexpr std::size_t shortest_shape  = 20;
    constexpr double      sharp_somewhere = -0.5;

    /** Variance of the centre line across itself, pixels^2, over the length of
     * a profile's mean: the median over its pixels. */
    double
    bends_of(const cv::Mat &line)
    {
      PixelPath pixels;
      cv::findNonZero(line, pixels);
      std::vector<float> across;
      for (const cv::Point &p : pixels)
        {
          const cv::Moments m = moments_around(line, p, profile_along);
          const double      d = std::hypot(m.mu20 - m.mu02, 2. * m.mu11);
          across.push_back(float(0.5 * (m.mu20 + m.mu02 - d) / m.m00));
        }
      return across.empty() ? 0.
                            : std::max(0., middle_value(across) - rounding);
    }



    /** Where a crack fades the profile says little: no deficit is more than
     * twice or less than half the median of its connected crack. */
    void
    limit_deficits(cv::Mat1f &deficits, const std::vector<LinePiece> &cracks)
    {
      for (const LinePiece &crack : cracks)
        {
          std::vector<float> sample;
          for (const cv::Point &p : crack.pixels)
            sample.push_back(deficits(p));
          const float middle = middle_value(sample);
          for (const cv::Point &p : crack.pixels)
            deficits(p) = std::clamp(deficits(p), 0.5F * middle, 2.F * middle);
        }
    }



    /** The medians over neighbours on the line: one grain is no widening. */
    Dip
    median_dip(const cv::Mat1f &deficits,
               const cv::Mat1f &peaks,
               const cv::Point &p)
    {
      const cv::Rect box =
        cv::Rect(p.x - 4, p.y - 4, 9, 9) & cv::Rect({0, 0}, deficits.size());
      std::vector<float> deficit, peak;
      for (int y = box.y; y < box.br().y; ++y)
        for (int x = box.x; x < box.br().x; ++x)
          if (deficits(y, x) > 0.F)
            {
              deficit.push_back(deficits(y, x));
              peak.push_back(peaks(y, x));
            }
      return {middle_value(deficit), middle_value(peak)};
    }



    /** Whether the picture shows a dark line along a crack. */
    bool
    shows_any_line(const std::vector<Dip> &dips)
    {
      std::vector<float> peaks;
      for (const Dip &dip : dips)
        peaks.push_back(float(dip.peak));
      return middle_value(peaks) >= least_peak;
    }



    /** How dark the line is about @p p: three of four pixels are no darker. */
    float
    darkness_about(const cv::Mat1f &peaks, const cv::Point &p)
    {
      const cv::Rect box = cv::Rect(p.x - beside_gap,
                                    p.y - beside_gap,
                                    2 * beside_gap + 1,
                                    2 * beside_gap + 1) &
                           cv::Rect({0, 0}, peaks.size());
      std::vector<float> sample;
      for (int y = box.y; y < box.br().y; ++y)
        for (int x = box.x; x < box.br().x; ++x)
          if (peaks(y, x) > 0.F)
            sample.push_back(peaks(y, x));
      if (sample.empty())
        return 0.F;
      const auto quarter = sample.begin() + 3 * sample.size() / 4;
      std::nth_element(sample.begin(), quarter, sample.end());
      return *quarter;
    }



    /** Pixels of the gaps of all @p line. Free ends are none: a crack may fade
     * there. */
    double
    bridged_pixels(const cv::Mat &line, const cv::Mat1f &peaks)
    {
      PixelPath pixels;
      cv::findNonZero(line, pixels);
      cv::Mat light = cv::Mat::zeros(line.size(), CV_8U);
      for (const cv::Point &p : pixels)
        if (peaks(p) < light_in_gap * darkness_about(peaks, p))
          light.at<uchar>(p) = 255;
      double sum = 0.;
      for (const LinePiece &gap : line_pieces(light))
        {
          const bool has_end = std::any_of(
            gap.pixels.begin(), gap.pixels.end(), [&line](const cv::Point &p) {
              return n_neighbours(line, p) < 2;
            });
          if (gap.pixels.size() >= shortest_gap && !has_end)
            sum += double(gap.pixels.size());
        }
      return sum;
    }



    /** The blur of an image by its cracks: where anything in it is sharp, that
     * of a lens in focus, whatever soft cracks look like. */
    OpticalBlur
    blur_of(const cv::Mat                       &grey,
            const std::vector<LinePiece>        &cracks,
            const cv::Mat                       &direction,
            const std::vector<std::vector<Dip>> &dips,
            const double                         bends)
    {
      std::vector<ProfileShape> shapes;
      for (std::size_t c = 0; c < cracks.size(); ++c)
        if (cracks[c].pixels.size() >= shortest_shape)
          shapes.push_back(
            shape_of_crack(grey, cracks[c].pixels, direction, dips[c]));
      const OpticalBlur blur = blur_of_cracks(shapes, bends);
      return blur.is_measured && sharpest_edges(grey) < sharp_somewhere
               ? OpticalBlur()
               : blur;
    }



    void
    fill_disc(cv::Mat &area, const cv::Point &p, const double width)
    {
      const double r  = 0.5 * std::max(1., width);
      const int    ir = int(std::ceil(r));
      for (int y = -ir; y <= ir; ++y)
        for (int x = -ir; x <= ir; ++x)
          {
            const cv::Point q(p.x + x, p.y + y);
            if (x * x + y * y <= r * r &&
                cv::Rect({0, 0}, area.size()).contains(q))
              area.at<uchar>(q) = 255;
          }
    }
  } // namespace



  double
  width_of_octaves(const int n_octaves)
  {
    return 4.5 * std::pow(2., n_octaves - 1);
  }



  CrackMap
  measure_cracks(const cv::Mat    &grey,
                 const cv::Mat    &centre_line,
                 const RidgeField &ridges,
                 const double      largest_width)
  {
    CrackMap map;
    map.centre_line        = centre_line;
    map.area               = cv::Mat::zeros(grey.size(), CV_8U);
    map.width              = cv::Mat::zeros(grey.size(), CV_32F);
    map.width_error        = cv::Mat::zeros(grey.size(), CV_32F);
    map.common_width_error = cv::Mat::zeros(grey.size(), CV_32F);
    map.direction          = cv::Mat::zeros(grey.size(), CV_32F);
    cv::Mat smooth;
    cv::GaussianBlur(grey, smooth, cv::Size(3, 3), 0.6);
    const std::vector<LinePiece> cracks   = line_pieces(centre_line);
    cv::Mat1f                    deficits = cv::Mat1f::zeros(grey.size());
    cv::Mat1f                    peaks    = cv::Mat1f::zeros(grey.size());
    cv::Mat1f                    doubts   = cv::Mat1f::zeros(grey.size());
    for (const LinePiece &crack : cracks)
      {
        for (const cv::Point &p : crack.pixels)
          map.direction.at<float>(p) =
            float(direction_at(centre_line, p, ridges.angle(p)));
        const std::vector<MeasuredDip> dips = dips_along(
          smooth, centre_line, crack, map.direction, 0.5 * largest_width);
        for (std::size_t i = 0; i < dips.size(); ++i)
          {
            deficits(crack.pixels[i]) = float(dips[i].dip.deficit);
            peaks(crack.pixels[i])    = float(dips[i].dip.peak);
            doubts(crack.pixels[i])   = float(dips[i].doubt);
          }
      }
    map.bridged = bridged_pixels(centre_line, peaks);
    limit_deficits(deficits, cracks);
    std::vector<std::vector<Dip>> dips;
    for (const LinePiece &crack : cracks)
      {
        dips.emplace_back();
        for (const cv::Point &p : crack.pixels)
          dips.back().push_back(median_dip(deficits, peaks, p));
      }
    const double bends = bends_of(centre_line);
    map.blur           = blur_of(grey, cracks, map.direction, dips, bends);
    const CrackDepth depth(dips, bends, map.blur);
    for (std::size_t c = 0; c < cracks.size(); ++c)
      {
        const bool shows_line = shows_any_line(dips[c]);
        if (!shows_line)
          map.without_line += double(dips[c].size());
        for (std::size_t i = 0; i < dips[c].size(); ++i)
          {
            const cv::Point        &p           = cracks[c].pixels[i];
            const Dip              &dip         = dips[c][i];
            const CrackDepth::Width w           = depth.width(dip);
            map.width.at<float>(p)              = float(w.value);
            map.width_error.at<float>(p)        = float(std::hypot(
              w.own,
              shows_line ? w.value * doubts(p) / dip.deficit : largest_width));
            map.common_width_error.at<float>(p) = float(w.common);
            fill_disc(map.area, p, w.value);
          }
      }
    return map;
  }
} // namespace squeal::tribology
