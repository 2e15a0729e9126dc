// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_images_crack_finder_h
#define squeal_tribology_images_crack_finder_h

#include <squeal/tribology/images/ridge_filter.h>

namespace squeal::tribology
{
  /** Cracks of one image. All of its size. */
  struct CrackMap
  {
    cv::Mat centre_line; /**< CV_8U, 255 on the skeleton */
    cv::Mat area;        /**< CV_8U, 255 on cracks */
    cv::Mat width;       /**< CV_32F, pixels, on the centre line */
    cv::Mat direction;   /**< CV_32F, radians in [0, pi), on the centre line */
  };

  /**
   * Centre lines of cracks.
   *
   * Crests of the ridge field above a level in units of noise are joined to
   * pieces. A piece counts by the sum of its strength over its axis; that of
   * background pieces is exponentially distributed, with a mean that the
   * median piece gives. A piece is a crack when fewer than one as strong is
   * expected in the whole image, and when it is stronger than an absolute
   * sum. Long pieces that are straight within 0.75 % of their length are
   * scratches, grooves or edges of the specimen. From the ends of cracks the
   * cheapest way over 35 pixels ahead is added as long as its mean strength
   * exceeds what the same search finds from crests of the background (median
   * and two robust deviations).
   *
   * Nothing depends on quantiles of the image: one without cracks gives none.
   */
  cv::Mat find_centre_lines(const RidgeField &ridges);

  /** Width, direction and area from the dark profile across the centre line:
   * the width is that at half the depth. @p grey is CV_32F. */
  CrackMap measure_cracks(const cv::Mat    &grey,
                          const cv::Mat    &centre_line,
                          const RidgeField &ridges);
} // namespace squeal::tribology

#endif
