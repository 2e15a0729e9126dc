// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/tribology/images/crack_depth.h>

#include <algorithm>
#include <cmath>

namespace squeal::tribology
{
  namespace
  {
    constexpr double assumed_mean  = 0.57; // depth, mean over an image
    constexpr double assumed_error = 0.10; // of that, deviation
    constexpr double spread        = 0.13; // of depths in an image
    // b^2 but for the bends that show: optics 0.49, pixel 1/12, smoothing and
    // interpolation of profiles 1/3 + 1/6, what a smoothed centre line hides of
    // the bends (0.3 pixels)^2.
    constexpr double straight_blur  = 1.163; // pixels^2
    constexpr double blur_error     = 0.20;  // of b, relative
    constexpr double peak_error     = 0.03;  // texture and noise
    constexpr double smallest_depth = 0.3, largest_depth = 0.95;

    double
    square(const double x)
    {
      return x * x;
    }



    /** Peak of a dip and how it changes with depth and with blur. */
    struct Peak
    {
      double value, by_depth, by_blur; // by_blur: by the logarithm of b
    };

    Peak
    peak_of(const double deficit, const double depth, const double blur)
    {
      const double x = deficit / depth / (2. * std::sqrt(2.) * blur);
      const double e = std::erf(x);
      const double s = 2. / std::sqrt(M_PI) * x * std::exp(-x * x);
      return {depth * e, std::max(1e-3, e - s), -depth * s};
    }



    /** What a dip says of its depth. */
    struct Depth
    {
      double value;
      double variance;
      double by_blur; // change with the logarithm of b
    };

    /** One step from a depth @p before. Judged there, not at its end: a narrow
     * crack with a peak a little too low could else pass for a wide one that
     * is shallow, of which the depth would be known well. */
    Depth
    depth_of(const Dip &dip, const double before, const double blur)
    {
      const Peak p = peak_of(dip.deficit, before, blur);
      return {before + (dip.peak - p.value) / p.by_depth,
              (square(peak_error) + square(blur_error * p.by_blur)) /
                square(p.by_depth),
              -p.by_blur / p.by_depth};
    }
  } // namespace



  CrackDepth::CrackDepth(const std::vector<std::vector<Dip>> &cracks,
                         const double                         bends)
    : blur(std::sqrt(straight_blur + bends))
    , mean_depth(assumed_mean)
    , error(assumed_error)
  {
    // Each crack has one vote: its pixels are wrong together.
    double sum = 0., depth = 0., by_blur = 0.;
    for (const std::vector<Dip> &crack : cracks)
      {
        double weights = 0., mean = 0., change = 0., length = 0.;
        for (const Dip &dip : crack)
          {
            const Depth  d = depth_of(dip, assumed_mean, blur);
            const double w = dip.deficit / d.variance;
            weights += w;
            mean += w * d.value;
            change += w * d.by_blur;
            length += dip.deficit;
          }
        if (weights <= 0.)
          continue;
        // The wider a crack the more of the area rests on its depth.
        const double w = 1. / (square(spread) + length / weights);
        sum += w;
        depth += w * mean / weights;
        by_blur += w * change / weights;
      }
    if (sum <= 0.)
      return;
    const double seen     = depth / sum;
    const double variance = 1. / sum + square(blur_error * by_blur / sum);
    const double part =
      square(assumed_error) / (square(assumed_error) + variance);
    mean_depth = assumed_mean + part * (seen - assumed_mean);
    error      = assumed_error * std::sqrt(1. - part);
  }



  CrackDepth::Width
  CrackDepth::width(const Dip &dip) const
  {
    const double prior = square(spread) + square(error);
    const Depth  d     = depth_of(dip, mean_depth, blur);
    const double seen  = prior / (prior + d.variance);
    const double depth = std::clamp(mean_depth + seen * (d.value - mean_depth),
                                    smallest_depth,
                                    largest_depth);
    const double width = dip.deficit / depth;
    const double own = square((1. - seen) * spread) + square(seen) * d.variance;
    return {width,
            width * std::sqrt(own) / depth,
            width * (1. - seen) * error / depth};
  }
} // namespace squeal::tribology
