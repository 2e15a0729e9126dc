// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/tribology/images/centre_line.h>
#include <squeal/tribology/images/crack_depth.h>
#include <squeal/tribology/images/crack_finder.h>

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace squeal::tribology
{
  namespace
  {
    constexpr int    profile_reach = 16;  // pixels to each side
    constexpr int    n_along       = 3;   // profiles averaged on each side
    constexpr double sample_step   = 0.5; // pixels
    constexpr double beyond_edge   = 1.5; // pixels, to the flank
    constexpr double flank_length  = 4.;  // pixels
    constexpr double off_line      = 1.;  // pixels, of the middle
    constexpr double beyond_half   = 1.;  // pixels, of the crack for its middle
    constexpr double rounding      = 1. / 12.; // pixels^2, of a skeleton
    constexpr double least_deficit = 0.1;      // pixels

    float
    median(std::vector<float> values)
    {
      const auto middle = values.begin() + values.size() / 2;
      std::nth_element(values.begin(), middle, values.end());
      return *middle;
    }



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
          const cv::Moments m = moments_around(line, p, n_along);
          const double      d = std::hypot(m.mu20 - m.mu02, 2. * m.mu11);
          across.push_back(float(0.5 * (m.mu20 + m.mu02 - d) / m.m00));
        }
      return across.empty() ? 0. : std::max(0., median(across) - rounding);
    }



    using Profile = std::vector<float>;

    /** Brightness from the line outwards to one @p side (-1 or 1), averaged
     * along the line. */
    Profile
    profile_at(const cv::Mat   &grey,
               const cv::Point &p,
               const double     angle,
               const int        side)
    {
      const double c = std::cos(angle), s = std::sin(angle);
      Profile      profile;
      for (double d = 0.; d <= profile_reach; d += sample_step)
        {
          float sum = 0.F;
          for (int t = -n_along; t <= n_along; ++t)
            sum += value_at(
              grey, p.x + t * c - side * d * s, p.y + t * s + side * d * c);
          profile.push_back(sum / (2 * n_along + 1));
        }
      return profile;
    }



    /** Distance at which the profile has climbed half way from the darkest
     * sample to its flank. */
    double
    half_depth_of(const Profile &profile)
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
    measure_flank(const Profile &profile, const double half_width)
    {
      const double edge = 2. * half_width + beyond_edge;
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



    /** Distance from the line to the middle of the missing light, pixels,
     * positive on the second side. The darkest sample would be chosen by noise,
     * and be darker for it. */
    double
    middle_of(const std::array<Profile, 2> &sides,
              const double                  half_width,
              const double                  brightness)
    {
      const int n   = std::min(int(sides[0].size()) - 1,
                             cvRound((half_width + beyond_half) / sample_step));
      double    sum = 0., moment = 0.;
      for (int i = -n; i <= n; ++i)
        {
          const double missing =
            brightness - (i < 0 ? sides[0][-i] : sides[1][i]);
          sum += missing;
          moment += missing * i * sample_step;
        }
      return sum > 0. ? std::clamp(moment / sum, -off_line, off_line) : 0.;
    }



    /** Missing light and depth of the profiles: neither optics nor pixels
     * change the former. The line may run beside the middle. */
    Dip
    dip_of(const std::array<Profile, 2> &sides, const double half_width)
    {
      double deficit = 0., brightness = 0.;
      for (const Profile &profile : sides)
        {
          const Flank flank = measure_flank(profile, half_width);
          deficit += flank.deficit;
          brightness += 0.5 * flank.brightness;
        }
      brightness           = std::max(1., brightness);
      const double   place = middle_of(sides, half_width, brightness);
      const Profile &side  = sides[place < 0. ? 0 : 1];
      const double   steps = std::abs(place) / sample_step;
      const int      i     = int(steps);
      const double   dark  = side[i] + (steps - i) * (side[i + 1] - side[i]);
      return {std::max(least_deficit, deficit / brightness),
              std::clamp(1. - dark / brightness, 0., 1.)};
    }



    /** The dips at the pixels of a crack. How far a profile reaches is the same
     * for all of them: texture would else be taken in where it is dark and left
     * out where it is bright, and a narrow crack look wider. */
    std::vector<Dip>
    dips_along(const cv::Mat   &grey,
               const LinePiece &crack,
               const cv::Mat   &direction)
    {
      std::vector<std::array<Profile, 2>> profiles;
      std::vector<float>                  halves;
      for (const cv::Point &p : crack.pixels)
        {
          const double a = direction.at<float>(p);
          profiles.push_back(
            {profile_at(grey, p, a, -1), profile_at(grey, p, a, 1)});
          halves.push_back(float(0.5 * (half_depth_of(profiles.back()[0]) +
                                        half_depth_of(profiles.back()[1]))));
        }
      const double     half_width = median(halves);
      std::vector<Dip> dips;
      for (const std::array<Profile, 2> &sides : profiles)
        dips.push_back(dip_of(sides, half_width));
      return dips;
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
          const float middle = median(sample);
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
      return {median(deficit), median(peak)};
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



  CrackMap
  measure_cracks(const cv::Mat    &grey,
                 const cv::Mat    &centre_line,
                 const RidgeField &ridges)
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
    for (const LinePiece &crack : cracks)
      {
        for (const cv::Point &p : crack.pixels)
          map.direction.at<float>(p) =
            float(direction_at(centre_line, p, ridges.angle(p)));
        const std::vector<Dip> dips = dips_along(smooth, crack, map.direction);
        for (std::size_t i = 0; i < dips.size(); ++i)
          {
            deficits(crack.pixels[i]) = float(dips[i].deficit);
            peaks(crack.pixels[i])    = float(dips[i].peak);
          }
      }
    limit_deficits(deficits, cracks);
    std::vector<std::vector<Dip>> dips;
    for (const LinePiece &crack : cracks)
      {
        dips.emplace_back();
        for (const cv::Point &p : crack.pixels)
          dips.back().push_back(median_dip(deficits, peaks, p));
      }
    const CrackDepth depth(dips, bends_of(centre_line));
    for (std::size_t c = 0; c < cracks.size(); ++c)
      for (std::size_t i = 0; i < dips[c].size(); ++i)
        {
          const cv::Point        &p           = cracks[c].pixels[i];
          const CrackDepth::Width w           = depth.width(dips[c][i]);
          map.width.at<float>(p)              = float(w.value);
          map.width_error.at<float>(p)        = float(w.own);
          map.common_width_error.at<float>(p) = float(w.common);
          fill_disc(map.area, p, w.value);
        }
    return map;
  }
} // namespace squeal::tribology
