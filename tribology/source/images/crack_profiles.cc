// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/tribology/images/crack_profiles.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace squeal::tribology
{
  namespace
  {
    constexpr double profile_reach = 16.; // pixels to each side
    constexpr double sample_step   = 0.5; // pixels
    constexpr double beyond_edge   = 1.5; // pixels, to the flank
    constexpr double flank_length  = 4.;  // pixels
    constexpr double off_line      = 1.;  // pixels, of the middle
    constexpr double beyond_half   = 1.;  // pixels, of the crack for its middle
    constexpr double least_deficit = 0.1; // pixels
    // Half the width of a crack whose flanks lie just within the profiles. Blur
    // reaches no farther from the edge of a wider one either.
    constexpr double widest_half = 5.25; // pixels
    // The next line of a profile, and the bright pixels beside a crack that are
    // enough for a flank.
    constexpr double first_other = 3.5, clear_beside = 2.; // pixels
    constexpr double least_fall = 0.3; // of the depth, behind a flank
    // A dark band is flat and has an edge: shares of its depth, and the depth
    // over the brightness beside it.
    constexpr int         edge_of_band = 2, beside_band = 4; // pixels
    constexpr double      least_band = 0.15, largest_dip = 0.35;
    constexpr std::size_t enough_pixels = 1000; // for the profile of a band
    // Of the missing light, where no flank is seen on either side.
    constexpr double no_flank = 0.5;

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



    using Profile = std::vector<float>;

    /** Brightness from the line outwards to one @p side (-1 or 1) as far as
     * @p reach, averaged along the line. */
    Profile
    profile_at(const cv::Mat   &grey,
               const cv::Point &p,
               const double     angle,
               const int        side,
               const double     reach)
    {
      const double c = std::cos(angle), s = std::sin(angle);
      Profile      profile;
      for (double d = 0.; d <= reach; d += sample_step)
        {
          float sum = 0.F;
          for (int t = -profile_along; t <= profile_along; ++t)
            sum += value_at(
              grey, p.x + t * c - side * d * s, p.y + t * s + side * d * c);
          profile.push_back(sum / (2 * profile_along + 1));
        }
      return profile;
    }



    /** Distance of the next line across the line at @p p on one @p side, of
     * @p reach where there is none. */
    double
    next_line(const cv::Mat   &lines,
              const cv::Point &p,
              const double     angle,
              const int        side,
              const double     reach)
    {
      const cv::Rect inside({0, 0}, lines.size());
      const double   c = std::cos(angle), s = std::sin(angle);
      for (double d = first_other; d < reach; d += sample_step)
        {
          const cv::Point at(cvRound(p.x - side * d * s),
                             cvRound(p.y + side * d * c));
          // A diagonal line has gaps for a diagonal way.
          for (const cv::Point &q : {at, at + cv::Point(1, 0)})
            if (inside.contains(q) && lines.at<uchar>(q) != 0)
              return d;
        }
      return reach;
    }



    /** The profiles on both sides of a pixel of a crack, and how far from the
     * line they tell of this crack. */
    struct Sides
    {
      std::array<Profile, 2> profiles;
      std::array<double, 2>  limits; /**< pixels */
    };

    int
    samples_within(const Profile &profile, const double limit)
    {
      return std::min(int(profile.size()), int(limit / sample_step) + 2);
    }



    /** Distance at which the profile has climbed half way from the darkest
     * sample to its flank. */
    double
    half_depth_of(const Profile &profile, const double limit)
    {
      // The flank is the brightest mean of three samples; it lies outside.
      float     flank = profile[0];
      const int n     = samples_within(profile, limit);
      for (int i = 1; i + 1 < n; ++i)
        {
          const float m = (profile[i - 1] + profile[i] + profile[i + 1]) / 3.F;
          if (m > flank)
            flank = m;
          // Behind a flank another dark line may begin.
          else if (m < flank - 0.5F * (flank - profile[0]) && i > 6)
            break;
        }
      const float half = 0.5F * (profile[0] + flank);
      for (int i = 1; i < n; ++i)
        if (profile[i] >= half)
          {
            const float rise = profile[i] - profile[i - 1];
            const float part =
              rise > 0.F ? (half - profile[i - 1]) / rise : 0.F;
            return sample_step * (i - 1 + part);
          }
      return sample_step * n;
    }



    /** Where the flank begins, pixels from the line. */
    double
    flank_begin(const double half_width)
    {
      return half_width + std::min(half_width, widest_half) + beyond_edge;
    }



    /** The brightness beside a crack, and up to where light is missing. */
    struct Flank
    {
      double brightness = 0.;   /**< grey levels */
      int    begin      = 0;    /**< sample */
      bool   is_clear   = true; /**< not taken too near to the crack */
    };

    Flank
    flank_of(const Profile &profile,
             const double   half_width,
             const double   limit)
    {
      const double edge =
        std::min(flank_begin(half_width), limit - sample_step);
      const int n = int(profile.size());
      Flank     flank;
      flank.begin = std::clamp(int(edge / sample_step), 1, n - 2);
      const int i1 =
        std::max(flank.begin + 1,
                 std::min(samples_within(profile, limit),
                          flank.begin + int(flank_length / sample_step) + 1));
      for (int i = flank.begin; i < i1; ++i)
        flank.brightness += profile[i] / (i1 - flank.begin);
      flank.is_clear = limit >= half_width + clear_beside;
      return flank;
    }



    double
    missing_light(const Profile &profile, const Flank &flank)
    {
      double sum = 0.;
      for (int i = 0; i < flank.begin; ++i)
        sum +=
          (i == 0 ? 0.5 : 1.) * sample_step * (flank.brightness - profile[i]);
      return sum;
    }



    /** Both flanks, those that lie on another line with the brightness of the
     * other side: half way between two lines as much light of this one is
     * missing beyond as that of the other one on this side. */
    std::array<Flank, 2>
    flanks_of(const Sides &sides, const double half_width)
    {
      std::array<Flank, 2> flanks;
      for (const int k : {0, 1})
        flanks[k] = flank_of(sides.profiles[k], half_width, sides.limits[k]);
      if (flanks[0].is_clear && flanks[1].is_clear)
        return flanks;
      const double brightness =
        flanks[0].is_clear ? flanks[0].brightness
        : flanks[1].is_clear
          ? flanks[1].brightness
          : std::max(flanks[0].brightness, flanks[1].brightness);
      for (Flank &flank : flanks)
        if (!flank.is_clear)
          flank.brightness = brightness;
      return flanks;
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
    MeasuredDip
    dip_of(const Sides &sides, const double half_width)
    {
      const std::array<Flank, 2> flanks  = flanks_of(sides, half_width);
      double                     deficit = 0., brightness = 0.;
      for (const int k : {0, 1})
        {
          deficit += missing_light(sides.profiles[k], flanks[k]);
          brightness += 0.5 * flanks[k].brightness;
        }
      brightness           = std::max(1., brightness);
      const double   place = middle_of(sides.profiles, half_width, brightness);
      const Profile &side  = sides.profiles[place < 0. ? 0 : 1];
      const double   steps = std::abs(place) / sample_step;
      const int      i     = int(steps);
      const double   dark  = side[i] + (steps - i) * (side[i + 1] - side[i]);
      MeasuredDip    result;
      result.dip = {std::max(least_deficit, deficit / brightness),
                    std::clamp(1. - dark / brightness, 0., 1.)};
      // A flank beside another line is the darker of two that should be alike.
      for (const int k : {0, 1})
        if (sides.limits[k] < flank_begin(half_width) + flank_length)
          result.doubt +=
            std::abs(flanks[0].brightness - flanks[1].brightness) / brightness *
            sample_step * flanks[k].begin;
      if (!flanks[0].is_clear && !flanks[1].is_clear)
        result.doubt += no_flank * result.dip.deficit;
      return result;
    }



    /** Mean brightness of a crack at whole distances from its line, of both
     * sides. */
    std::vector<double>
    mean_profile(const cv::Mat   &grey,
                 const LinePiece &crack,
                 const cv::Mat   &direction,
                 const int        reach)
    {
      std::vector<double> profile(reach + 1, 0.);
      const std::size_t   n    = crack.pixels.size();
      const std::size_t   step = 1 + n / enough_pixels;
      const double        part = 0.5 / double((n + step - 1) / step);
      for (std::size_t i = 0; i < n; i += step)
        {
          const cv::Point &p = crack.pixels[i];
          const double     a = direction.at<float>(p);
          for (int d = 0; d <= reach; ++d)
            for (const int side : {-1, 1})
              profile[d] += part * value_at(grey,
                                            p.x - side * d * std::sin(a),
                                            p.y + side * d * std::cos(a));
        }
      return profile;
    }



    double
    mean_between(const std::vector<double> &values, const int i0, const int i1)
    {
      return std::accumulate(values.begin() + i0, values.begin() + i1, 0.) /
             (i1 - i0);
    }



    /** Half the width of the dark band in whose middle a crack's line runs,
     * where it is too wide for the profiles and at most @p largest; else 0.
     * Noise within such a band would pass for its flank at a single pixel. */
    double
    half_of_band(const cv::Mat   &grey,
                 const LinePiece &crack,
                 const cv::Mat   &direction,
                 const double     largest)
    {
      const int first = int(widest_half), last = int(largest) + 1;
      if (last <= first + 1)
        return 0.;
      const std::vector<double> b =
        mean_profile(grey, crack, direction, last + edge_of_band + beside_band);
      double half = 0., most = 0.;
      for (int e = first; e <= last; ++e)
        {
          const double inner = mean_between(b, 0, e - edge_of_band + 1),
                       outer = mean_between(
                         b, e + edge_of_band, e + edge_of_band + beside_band),
                       step = outer - inner;
          if (step <= most || step < least_band * outer ||
              mean_between(b, 0, edge_of_band + 1) < inner - largest_dip * step)
            continue;
          int d = e - edge_of_band;
          while (d < e + edge_of_band && b[d + 1] < inner + 0.5 * step)
            ++d;
          most = step;
          half = d + std::clamp((inner + 0.5 * step - b[d]) /
                                  std::max(1e-3, b[d + 1] - b[d]),
                                0.,
                                1.);
        }
      return half > widest_half ? half : 0.;
    }



    /** Where the mean of the profiles of a crack falls again behind its flank
     * on one side: another dark line begins there. */
    double
    fall_behind_flank(const std::vector<Sides> &sides,
                      const int                 k,
                      const double              half_width)
    {
      std::vector<double> mean(sides[0].profiles[k].size(), 0.);
      for (const Sides &at : sides)
        for (std::size_t i = 0; i < mean.size(); ++i)
          mean[i] += at.profiles[k][i] / double(sides.size());
      const int end =
        std::min(int(mean.size()) - 1,
                 int((flank_begin(half_width) + flank_length) / sample_step));
      double top = mean[0];
      int    at  = 0;
      for (int i = int(half_width / sample_step) + 1; i <= end; ++i)
        if (mean[i] > top)
          {
            top = mean[i];
            at  = i;
          }
        else if (top - mean[0] > least_peak * top &&
                 mean[i] < top - least_fall * (top - mean[0]))
          return sample_step * at;
      return sample_step * double(mean.size());
    }
  } // namespace


  float
  middle_value(std::vector<float> values)
  {
    const auto middle = values.begin() + values.size() / 2;
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
  }



  std::vector<MeasuredDip>
  dips_along(const cv::Mat   &grey,
             const cv::Mat   &lines,
             const LinePiece &crack,
             const cv::Mat   &direction,
             const double     largest_half)
  {
    const double band  = half_of_band(grey, crack, direction, largest_half);
    const double reach = band > 0.
                           ? std::ceil(flank_begin(band) + flank_length) + 1.
                           : profile_reach;
    std::vector<Sides> all;
    std::vector<float> halves;
    for (const cv::Point &p : crack.pixels)
      {
        const double a = direction.at<float>(p);
        Sides        sides;
        double       half = 0.;
        for (const int k : {0, 1})
          {
            const int side    = 2 * k - 1;
            sides.profiles[k] = profile_at(grey, p, a, side, reach);
            // Half way to the next line, if it is near enough to matter.
            sides.limits[k] = 0.5 * next_line(lines, p, a, side, 2. * reach);
            half += 0.5 * half_depth_of(sides.profiles[k], sides.limits[k]);
          }
        halves.push_back(float(half));
        all.push_back(sides);
      }
    const double half_width = band > 0. ? band : middle_value(halves);
    for (const int k : {0, 1})
      {
        const double limit = fall_behind_flank(all, k, half_width);
        for (Sides &sides : all)
          sides.limits[k] = std::min(sides.limits[k], limit);
      }
    std::vector<MeasuredDip> dips;
    for (const Sides &sides : all)
      dips.push_back(dip_of(sides, half_width));
    return dips;
  }
} // namespace squeal::tribology
