// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/tribology/images/line_features.h>
#include <squeal/tribology/images/line_graph.h>

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace squeal::tribology
{
  namespace
  {
    // In pixels.
    constexpr double near_flank = 2., flank = 4., wide_flank = 6., far = 9.;
    constexpr int    texture_window = 25, clutter_window = 41;
    constexpr int    reduction       = 4;  // of maps of parallel crests
    constexpr int    parallel_window = 31; // reduced pixels
    constexpr int    turn_step       = 8;
    constexpr int    straight_part   = 40;
    constexpr double run_unit        = 20.;
    constexpr double at_border       = 12.; // from the end of a straight run
    // Of the lay: directions, and pixels of the image reduced by half.
    constexpr int    n_lay = 32, lay_taps = 11, lay_step = 2;
    constexpr double lay_grain   = 6.;    // deviation of what is no line
    constexpr float  least_lay   = 1e-3F; // grey levels
    constexpr double least_depth = 0.5;   // grey levels

    float
    quantile(std::vector<float> values, const double share)
    {
      if (values.empty())
        return 0.F;
      const std::size_t k =
        std::min(values.size() - 1, std::size_t(share * double(values.size())));
      std::nth_element(values.begin(), values.begin() + k, values.end());
      return values[k];
    }



    float
    image_median(const cv::Mat1f &values)
    {
      std::vector<float> sample;
      for (int y = 0; y < values.rows; y += 3)
        for (int x = 0; x < values.cols; x += 3)
          sample.push_back(values(y, x));
      return quantile(std::move(sample), 0.5);
    }



    /** Root mean square deviation from the mean of a window. */
    cv::Mat1f
    spread_of(const cv::Mat1f &values, const int window)
    {
      cv::Mat1f      mean, square;
      const cv::Size size(window, window);
      cv::blur(values, mean, size, {-1, -1}, cv::BORDER_REFLECT_101);
      cv::sqrBoxFilter(
        values, square, CV_32F, size, {-1, -1}, true, cv::BORDER_REFLECT_101);
      square -= mean.mul(mean);
      cv::max(square, 0., square);
      cv::sqrt(square, square);
      return square;
    }



    /** Mean over a line of taps about each pixel. */
    cv::Mat1f
    averaged_in_direction(const cv::Mat1f &values, const double angle)
    {
      const double reach = 0.5 * (lay_taps - 1) * lay_step;
      const int    rim   = int(reach) + 1;
      cv::Mat1f    padded, sum = cv::Mat1f::zeros(values.size());
      cv::copyMakeBorder(
        values, padded, rim, rim, rim, rim, cv::BORDER_REFLECT_101);
      for (int i = 0; i < lay_taps; ++i)
        {
          const double t = i * lay_step - reach;
          sum += padded(cv::Rect(rim + cvRound(t * std::cos(angle)),
                                 rim + cvRound(t * std::sin(angle)),
                                 values.cols,
                                 values.rows));
        }
      return sum * (1. / lay_taps);
    }



    /** Both flanks of the narrowest filter lie inside of the image: the
     * contrast is known. */
    bool
    is_known(const RidgeField &ridges, const cv::Point &p)
    {
      const cv::Point across = ridges.across(p, ridges.flank);
      const int       x = std::abs(across.x), y = std::abs(across.y);
      const cv::Size  size = ridges.local.size();
      return p.x >= x && p.x < size.width - x && p.y >= y &&
             p.y < size.height - y;
    }



    /** Those pixels whose contrast is known; all of them if that is less than
     * half: a line is not judged by a few pixels. */
    PixelPath
    known_pixels(const RidgeField &ridges, const PixelPath &axis)
    {
      PixelPath known;
      for (const cv::Point &p : axis)
        if (is_known(ridges, p))
          known.push_back(p);
      return 2 * known.size() < axis.size() ? axis : known;
    }



    double
    mean_turn(const PixelPath &path)
    {
      double    sum = 0.;
      int       n   = 0;
      const int m   = int(path.size());
      for (int i = turn_step; i + turn_step < m; i += turn_step / 2)
        {
          const cv::Point2d a = path[i] - path[i - turn_step];
          const cv::Point2d b = path[i + turn_step] - path[i];
          const double c = a.dot(b) / std::max(1e-9, cv::norm(a) * cv::norm(b));
          sum += std::acos(std::clamp(c, -1., 1.));
          ++n;
        }
      // A short line says nothing: what others have on the mean.
      return n > 0 ? sum / n : 0.3;
    }



    /** The straight line that a piece lies on, or half of its parts do: a
     * groove may lead into something else. */
    StraightRun
    main_run(const cv::Mat &crests, const LinePiece &piece)
    {
      StraightRun       best    = straight_run_of(crests, piece);
      const std::size_t n       = piece.axis.size();
      const std::size_t n_parts = n / straight_part;
      if (best.length > 0. || n_parts < 2)
        return best;
      std::size_t n_on = 0;
      for (std::size_t k = 0; k < n_parts; ++k)
        {
          LinePiece part;
          part.axis.assign(piece.axis.begin() + k * n / n_parts,
                           piece.axis.begin() + (k + 1) * n / n_parts);
          const StraightRun run = straight_run_of(crests, part);
          n_on += run.length > 2. * straight_part;
          if (run.length > best.length)
            best = run;
        }
      return 2 * n_on >= n_parts ? best : StraightRun();
    }



    double &
    value(LineFeatures &f, const LineFeature k)
    {
      return f[std::size_t(k)];
    }
  } // namespace



  LineMeter::LineMeter(const cv::Mat    &grey,
                       const RidgeField &ridges,
                       const cv::Mat    &crests)
    : ridges(ridges)
    , crests(crests)
  {
    cv::GaussianBlur(grey, smooth, cv::Size(), 1.);
    texture       = spread_of(smooth, texture_window);
    bulk          = std::max(1.F, image_median(grey));
    usual_texture = std::max(0.1F, image_median(texture));
    measure_darkness();
    count_crests();
    measure_lay();
  }



  float
  LineMeter::smooth_at(const cv::Point &p) const
  {
    return smooth(std::clamp(p.y, 0, smooth.rows - 1),
                  std::clamp(p.x, 0, smooth.cols - 1));
  }



  float
  LineMeter::depth_at(const cv::Point &p, const double distance) const
  {
    const cv::Point across = ridges.across(p, distance);
    return 0.5F * (smooth_at(p + across) + smooth_at(p - across)) -
           smooth_at(p);
  }



  float
  LineMeter::difference_at(const cv::Point &p, const double distance) const
  {
    const cv::Point across = ridges.across(p, distance);
    return smooth_at(p + across) - smooth_at(p - across);
  }



  void
  LineMeter::measure_darkness()
  {
    dark.create(smooth.size());
    for (int y = 0; y < dark.rows; ++y)
      for (int x = 0; x < dark.cols; ++x)
        {
          const cv::Point p(x, y), across = ridges.across(p, flank);
          const float     beside = std::max(
            1.F, std::min(smooth_at(p + across), smooth_at(p - across)));
          dark(p) = (beside - std::max(1.F, smooth(p))) / beside;
        }
  }



  void
  LineMeter::count_crests()
  {
    constexpr int n = RidgeField::n_directions;
    cv::Mat       share;
    crests.convertTo(share, CV_32F, 1. / 255.);
    cv::boxFilter(share,
                  clutter,
                  CV_32F,
                  {clutter_window, clutter_window},
                  {-1, -1},
                  true,
                  cv::BORDER_REFLECT_101);
    const cv::Size           small(std::max(1, crests.cols / reduction),
                         std::max(1, crests.rows / reduction));
    std::array<cv::Mat1f, n> counts;
    for (cv::Mat1f &m : counts)
      m = cv::Mat1f::zeros(small);
    for (int y = 0; y < crests.rows; ++y)
      for (int x = 0; x < crests.cols; ++x)
        if (crests.at<uchar>(y, x) != 0)
          counts[ridges.direction.at<uchar>(y, x)](
            std::min(y / reduction, small.height - 1),
            std::min(x / reduction, small.width - 1)) += 1.F;
    for (int t = 0; t < n; ++t)
      {
        const cv::Mat sum =
          counts[t] + counts[(t + 1) % n] + counts[(t + n - 1) % n];
        cv::boxFilter(sum,
                      alike[t],
                      CV_32F,
                      {parallel_window, parallel_window},
                      {-1, -1},
                      true,
                      cv::BORDER_REFLECT_101);
        alike[t] *= 1. / (reduction * reduction);
      }
  }



  void
  LineMeter::measure_lay()
  {
    cv::Mat1f half, coarse;
    cv::resize(smooth,
               half,
               cv::Size((smooth.cols + 1) / 2, (smooth.rows + 1) / 2),
               0.,
               0.,
               cv::INTER_AREA);
    cv::GaussianBlur(half, coarse, cv::Size(), lay_grain);
    half -= coarse;
    // The median of the size: few pixels lie on any one line.
    std::vector<float> sizes;
    for (int t = 0; t < n_lay; ++t)
      {
        const cv::Mat1f mean =
          cv::abs(averaged_in_direction(half, CV_PI * t / n_lay));
        sizes.push_back(std::max(least_lay, image_median(mean)));
      }
    const double usual = quantile(sizes, 0.5);
    for (const float s : sizes)
      lay.push_back(std::log(s / usual));
  }



  void
  LineMeter::measure_profile(const PixelPath &core, LineFeatures &f) const
  {
    using F = LineFeature;
    std::vector<float> contrasts, unlimited, darks, levels;
    for (const cv::Point &p : known_pixels(ridges, core))
      {
        contrasts.push_back(ridges.local.at<float>(p));
        unlimited.push_back(ridges.unlimited.at<float>(p));
        value(f, F::contrast) += contrasts.back();
      }
    value(f, F::contrast) /= double(contrasts.size());
    double depth = 0., near = 0., wide = 0., difference = 0., distant = 0.;
    const double share = 1. / double(core.size());
    for (const cv::Point &p : core)
      {
        value(f, F::path) += share * ridges.strength.at<float>(p);
        value(f, F::coarse_path) += share * ridges.coarse.at<float>(p);
        value(f, F::darkness) += share * dark(p);
        darks.push_back(dark(p));
        levels.push_back(smooth(p));
        depth += share * depth_at(p, flank);
        near += share * depth_at(p, near_flank);
        wide += share * depth_at(p, wide_flank);
        difference += share * difference_at(p, flank);
        distant += share * difference_at(p, far);
      }
    double n_dark = 0.;
    for (const float d : darks)
      n_dark += d > 0.5 * value(f, F::darkness);
    const double d          = std::max(least_depth, depth);
    value(f, F::continuity) = n_dark * share;
    value(f, F::peak_contrast) =
      std::log(std::max(0.3F, quantile(unlimited, 0.5)));
    value(f, F::weak_contrast) = quantile(contrasts, 0.25);
    value(f, F::weak_darkness) = quantile(darks, 0.25);
    value(f, F::level)         = quantile(levels, 0.5) / bulk;
    value(f, F::asymmetry)     = std::min(3., std::abs(difference) / d);
    value(f, F::far_asymmetry) = std::min(5., std::abs(distant) / d);
    value(f, F::narrowness)    = std::clamp(near / d, -1., 2.);
    value(f, F::breadth)       = std::clamp(wide / d, -1., 3.);
    value(f, F::depth)         = depth / bulk;
  }



  void
  LineMeter::measure_surroundings(const PixelPath &core, LineFeatures &f) const
  {
    using F             = LineFeature;
    const double share  = 1. / double(core.size());
    double       around = 0., others = 0.;
    for (const cv::Point &p : core)
      {
        around += share * texture(p);
        value(f, F::clutter) += share * clutter(p);
        const cv::Mat1f &same = alike[ridges.direction.at<uchar>(p)];
        others += share * same(std::min(p.y / reduction, same.rows - 1),
                               std::min(p.x / reduction, same.cols - 1));
      }
    // The line itself is one of those that run as it does.
    const double window = parallel_window * reduction;
    const double own =
      std::min(double(core.size()), window) / (window * window);
    value(f, F::texture)          = around / usual_texture;
    value(f, F::parallels)        = std::max(0., others - own) * window;
    value(f, F::depth_in_texture) = value(f, F::depth) * bulk / (around + 0.1);
  }



  void
  LineMeter::measure_shape(const LinePiece &piece,
                           const PixelPath &core,
                           LineFeatures    &f) const
  {
    using F                   = LineFeature;
    const StraightRun run     = main_run(crests, piece);
    value(f, F::length)       = std::log(double(core.size()));
    value(f, F::waviness)     = piece.waviness() / double(core.size());
    value(f, F::turning)      = mean_turn(core);
    value(f, F::straight_run) = std::log1p(run.length / run_unit);
    const cv::Point2d chord   = piece.axis.back() - piece.axis.front();
    const int         turn =
      cvRound(n_lay * std::atan2(chord.y, chord.x) / CV_PI) + 2 * n_lay;
    value(f, F::lay)    = lay[turn % n_lay];
    value(f, F::groove) = value(f, F::straight_run) * value(f, F::lay);
    if (run.length > 0.)
      for (const cv::Point2d &end : {run.first, run.last})
        value(f, F::through) +=
          0.5 *
          (std::min(
             {end.x, end.y, crests.cols - 1 - end.x, crests.rows - 1 - end.y}) <
           at_border);
  }



  LineFeatures
  LineMeter::measure(const LinePiece &piece, const PixelPath &core) const
  {
    LineFeatures f{};
    measure_profile(core, f);
    measure_surroundings(core, f);
    measure_shape(piece, core, f);
    return f;
  }
} // namespace squeal::tribology
