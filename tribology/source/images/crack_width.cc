// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/tribology/images/centre_line.h>
#include <squeal/tribology/images/crack_finder.h>

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>

namespace squeal::tribology
{
  namespace
  {
    constexpr int    profile_reach = 16;   // pixels to each side
    constexpr int    n_along       = 3;    // profiles averaged on each side
    constexpr double sample_step   = 0.5;  // pixels
    constexpr double beyond_edge   = 1.5;  // pixels, to the flank
    constexpr double flank_length  = 4.;   // pixels
    constexpr double usual_depth   = 0.52; // of the brightness beside it

    float
    value_at(const cv::Mat &grey, const double x, const double y)
    {
      const int    ix = std::clamp(int(std::floor(x)), 0, grey.cols - 2);
      const int    iy = std::clamp(int(std::floor(y)), 0, grey.rows - 2);
      const float  fx = float(std::clamp(x - ix, 0., 1.));
      const float  fy = float(std::clamp(y - iy, 0., 1.));
      const float *a  = grey.ptr<float>(iy) + ix,
                  *b  = grey.ptr<float>(iy + 1) + ix;
      return (1.F - fy) * ((1.F - fx) * a[0] + fx * a[1]) +
             fy * ((1.F - fx) * b[0] + fx * b[1]);
    }



    /** Direction of the centre line from the pixels within five of @p p. */
    double
    direction_at(const cv::Mat &line, const cv::Point &p, const double fallback)
    {
      const cv::Rect box =
        cv::Rect(p.x - 5, p.y - 5, 11, 11) & cv::Rect({0, 0}, line.size());
      const cv::Moments m = cv::moments(line(box), true);
      if (m.m00 < 4.)
        return fallback;
      const double a = 0.5 * std::atan2(2. * m.mu11, m.mu20 - m.mu02);
      return a < 0. ? a + CV_PI : a;
    }



    /** Distance at which the profile has climbed half way from the darkest
     * sample to its flank. */
    double
    half_depth(const std::vector<float> &profile)
    {
      // The flank is the brightest mean of three samples; it lies outside.
      float flank = profile[0];
      for (std::size_t i = 1; i + 1 < profile.size(); ++i)
        {
          const float m = (profile[i - 1] + profile[i] + profile[i + 1]) / 3.F;
          if (m > flank)
            flank = m;
          // Behind a flank another dark line may begin.
          else if (m < flank - 0.5F * (flank - profile[0]) && i > 6)
            break;
        }
      const float half = 0.5F * (profile[0] + flank);
      for (std::size_t i = 1; i < profile.size(); ++i)
        if (profile[i] >= half)
          {
            const float rise = profile[i] - profile[i - 1];
            const float part =
              rise > 0.F ? (half - profile[i - 1]) / rise : 0.F;
            return sample_step * (i - 1 + part);
          }
      return sample_step * profile.size();
    }



    /** Light that is missing on one side, and the brightness beside it. */
    struct Flank
    {
      double deficit    = 0.; /**< grey levels times pixels */
      double brightness = 0.; /**< grey levels */
    };

    Flank
    measure_flank(const std::vector<float> &profile)
    {
      const double edge = 2. * half_depth(profile) + beyond_edge;
      const int    n    = int(profile.size());
      const int    i0   = std::clamp(int(edge / sample_step), 1, n - 2);
      const int    i1   = std::min(n, i0 + int(flank_length / sample_step) + 1);
      Flank        flank;
      for (int i = i0; i < i1; ++i)
        flank.brightness += profile[i] / (i1 - i0);
      for (int i = 0; i < i0; ++i)
        flank.deficit +=
          (i == 0 ? 0.5 : 1.) * sample_step * (flank.brightness - profile[i]);
      return flank;
    }



    /** Missing light over the depth of the profile: neither optics nor pixels
     * change it. A crack too narrow to show its depth counts as one of the
     * usual depth. */
    double
    width_at(const cv::Mat &grey, const cv::Point &p, const double angle)
    {
      const double c = std::cos(angle), s = std::sin(angle);
      Flank        both;
      double       darkest = 0.;
      for (const int side : {-1, 1})
        {
          std::vector<float> profile;
          for (double d = 0.; d <= profile_reach; d += sample_step)
            {
              float sum = 0.F;
              for (int t = -n_along; t <= n_along; ++t)
                sum += value_at(
                  grey, p.x + t * c - side * d * s, p.y + t * s + side * d * c);
              profile.push_back(sum / (2 * n_along + 1));
            }
          const Flank flank = measure_flank(profile);
          both.deficit += flank.deficit;
          both.brightness += 0.5 * flank.brightness;
          darkest = profile[0];
        }
      const double depth = std::max(
        {both.brightness - darkest, usual_depth * both.brightness, 1.});
      return std::max(0., both.deficit / depth);
    }



    /** Where a crack fades the profile says little: no width is more than
     * twice or less than half the median of its connected crack. */
    void
    limit_widths(cv::Mat &widths)
    {
      for (const LinePiece &piece : line_pieces(widths > 0.))
        {
          std::vector<float> sample;
          for (const cv::Point &p : piece.pixels)
            sample.push_back(widths.at<float>(p));
          const auto middle = sample.begin() + sample.size() / 2;
          std::nth_element(sample.begin(), middle, sample.end());
          for (const cv::Point &p : piece.pixels)
            {
              float &w = widths.at<float>(p);
              w        = std::clamp(w, 0.5F * *middle, 2.F * *middle);
            }
        }
    }
  } // namespace



  CrackMap
  measure_cracks(const cv::Mat    &grey,
                 const cv::Mat    &centre_line,
                 const RidgeField &ridges)
  {
    CrackMap map;
    map.centre_line = centre_line;
    map.area        = cv::Mat::zeros(grey.size(), CV_8U);
    map.width       = cv::Mat::zeros(grey.size(), CV_32F);
    map.direction   = cv::Mat::zeros(grey.size(), CV_32F);
    cv::Mat smooth;
    cv::GaussianBlur(grey, smooth, cv::Size(3, 3), 0.6);
    PixelPath pixels;
    cv::findNonZero(centre_line, pixels);
    cv::Mat raw = cv::Mat::zeros(grey.size(), CV_32F);
    for (const cv::Point &p : pixels)
      {
        const double a = direction_at(centre_line, p, ridges.angle(p));
        map.direction.at<float>(p) = float(a);
        raw.at<float>(p) = float(std::max(0.2, width_at(smooth, p, a)));
      }
    limit_widths(raw);
    for (const cv::Point &p : pixels)
      {
        // The median over neighbours on the line: one grain is no widening.
        const cv::Rect box =
          cv::Rect(p.x - 4, p.y - 4, 9, 9) & cv::Rect({0, 0}, grey.size());
        std::vector<float> widths;
        for (int y = box.y; y < box.br().y; ++y)
          for (int x = box.x; x < box.br().x; ++x)
            if (raw.at<float>(y, x) > 0.F)
              widths.push_back(raw.at<float>(y, x));
        const auto middle = widths.begin() + widths.size() / 2;
        std::nth_element(widths.begin(), middle, widths.end());
        const double width     = *middle;
        map.width.at<float>(p) = float(width);
        const double r         = 0.5 * std::max(1., width);
        const int    ir        = int(std::ceil(r));
        for (int y = -ir; y <= ir; ++y)
          for (int x = -ir; x <= ir; ++x)
            if (x * x + y * y <= r * r)
              {
                const cv::Point q(p.x + x, p.y + y);
                if (cv::Rect({0, 0}, grey.size()).contains(q))
                  map.area.at<uchar>(q) = 255;
              }
      }
    return map;
  }
} // namespace squeal::tribology
