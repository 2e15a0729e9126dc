// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/tribology/images/frame_overlap.h>

#include <opencv2/imgproc.hpp>
#include <opencv2/video/tracking.hpp>

#include <algorithm>
#include <cmath>

namespace squeal::tribology
{
  namespace
  {
    /** Blocks of so many pixels leave nothing of the noise of a detector, and
     * their means spread by so many grey levels where anything is shown. */
    constexpr double block_edge = 8., least_spread = 3.;

    /** Gaussian that is left of shading in such means, blocks. */
    constexpr double shading_blocks = 4.;

    /** Gaussians that take out noise and shading, px, and how far from a place
     * another one begins. */
    constexpr double noise_scale = 1.1, shading_scale = 8., peak_radius = 8.;

    /** Frames that do not show the same lead by as much on fewer than 1 of 100
     * overlaps; see lead_over_other_shifts(). */
    constexpr double least_lead = 1.6;

    /** Below it not even the shading of two frames fits. */
    constexpr double least_correlation = 0.3;

    cv::Mat
    without_shading(const cv::Mat &part)
    {
      cv::Mat fine, coarse;
      cv::GaussianBlur(part, fine, {}, noise_scale);
      cv::GaussianBlur(part, coarse, {}, shading_scale);
      fine -= coarse;
      return fine - cv::mean(fine);
    }



    /** The largest size up to @p n that is transformed fast. */
    int
    fast_size(int n)
    {
      while (n > 1 && cv::getOptimalDFTSize(n) != n)
        --n;
      return n;
    }



    /** Of two parts of one size, periodic, at all shifts. */
    cv::Mat1f
    correlations(const cv::Mat &fixed, const cv::Mat &moving)
    {
      const cv::Rect fast(
        {0, 0}, cv::Size(fast_size(fixed.cols), fast_size(fixed.rows)));
      const cv::Mat a = without_shading(fixed)(fast),
                    b = without_shading(moving)(fast);
      cv::Mat of_a, of_b, product;
      cv::dft(a, of_a);
      cv::dft(b, of_b);
      cv::mulSpectrums(of_a, of_b, product, 0, true);
      cv::Mat1f sums;
      cv::idft(product, sums, cv::DFT_SCALE | cv::DFT_REAL_OUTPUT);
      return sums / std::max(cv::norm(a) * cv::norm(b), 1e-30);
    }
  } // namespace



  cv::Rect
  shared_part(const cv::Mat     &fixed,
              const cv::Mat     &moving,
              const cv::Point2d &shift)
  {
    return cv::Rect({0, 0}, fixed.size()) &
           cv::Rect({cvRound(shift.x), cvRound(shift.y)}, moving.size());
  }



  bool
  is_wide_enough(const cv::Rect &overlap)
  {
    return overlap.width >= least_overlap && overlap.height >= least_overlap;
  }



  bool
  shows_anything(const cv::Mat &part)
  {
    cv::Mat    coarse, shading;
    cv::Scalar mean, spread;
    cv::resize(part,
               coarse,
               cv::Size(),
               1. / block_edge,
               1. / block_edge,
               cv::INTER_AREA);
    cv::GaussianBlur(coarse, shading, {}, shading_blocks);
    cv::meanStdDev(coarse - shading, mean, spread);
    return spread[0] >= least_spread;
  }



  double
  lead_over_other_shifts(const cv::Mat &fixed, const cv::Mat &moving)
  {
    if (fixed.empty())
      return 0.;
    const cv::Mat1f c    = correlations(fixed, moving);
    double          here = -1., best = -1., sum = 0., n = 0.;
    for (int y = 0; y < c.rows; ++y)
      for (int x = 0; x < c.cols; ++x)
        {
          const int dx = std::min(x, c.cols - x), dy = std::min(y, c.rows - y);
          const double r = std::clamp<double>(c(y, x), -0.9999, 0.9999);
          // The shift of a fit is no whole number.
          if (dx <= 1 && dy <= 1)
            here = std::max(here, r);
          if (std::hypot(dx, dy) <= peak_radius)
            continue;
          best = std::max(best, r);
          sum += r * r;
          ++n;
        }
    return sum > 0. ? (std::atanh(here) - std::atanh(best)) / std::sqrt(sum / n)
                    : 0.;
  }



  std::optional<cv::Point2d>
  refine_shift(const cv::Mat     &fixed,
               const cv::Mat     &moving,
               const cv::Point2d &start)
  {
    const cv::Point whole(cvRound(start.x), cvRound(start.y));
    const cv::Rect  overlap = shared_part(fixed, moving, start);
    if (!is_wide_enough(overlap))
      return std::nullopt;
    cv::Mat1f     warp = cv::Mat1f::eye(2, 3);
    const cv::Mat a    = fixed(overlap);
    const cv::Mat b    = moving(overlap - whole);
    try
      {
        const double correlation = cv::findTransformECC(
          a,
          b,
          warp,
          cv::MOTION_TRANSLATION,
          cv::TermCriteria(
            cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 200, 1e-6),
          cv::noArray(),
          5);
        if (!(correlation >= least_correlation))
          return std::nullopt;
      }
    catch (const cv::Exception &)
      {
        // It throws when it does not converge.
        return std::nullopt;
      }
    // A point p of the fixed image is at p + warp in the moving one.
    const cv::Point2d found =
      cv::Point2d(whole) - cv::Point2d(warp(0, 2), warp(1, 2));
    const bool is_clear =
      lead_over_other_shifts(fixed(shared_part(fixed, moving, found)),
                             moving(shared_part(moving, fixed, -found))) >=
      least_lead;
    return is_clear ? std::optional(found) : std::nullopt;
  }
} // namespace squeal::tribology
