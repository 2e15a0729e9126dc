// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_images_line_smoothing_h
#define squeal_tribology_images_line_smoothing_h

#include <opencv2/core.hpp>

#include <vector>

namespace squeal::tribology
{
  using Curve = std::vector<cv::Point2d>; /**< pixels */

  /** Weights of a mean over the neighbours along a line, up to @p reach to each
   * side: a normal distribution of @p deviation, pixels. Their sum is 1. */
  std::vector<double> mean_weights(const double deviation, const int reach);

  /** Weighted means of each point and its neighbours on both sides. Beyond
   * its ends a line goes on as its image in the end point, which therefore
   * stays; a ring, whose last point is its first, goes on around. */
  Curve averaged_along(const Curve               &line,
                       const bool                 is_ring,
                       const std::vector<double> &weights);
} // namespace squeal::tribology

#endif
