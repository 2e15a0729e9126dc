// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_images_seen_pixels_h
#define squeal_tribology_images_seen_pixels_h

#include <opencv2/core.hpp>

namespace squeal::tribology
{
  /**
   * Which pixels of an image show the specimen: CV_8U of its size, 255 where
   * they do; an empty map stands for all of them. What is not seen is no area,
   * has no cracks and is no part of any quantile.
   */
  using SeenPixels = cv::Mat;

  /** Number of pixels that are seen, of @p size in all. */
  int n_seen(const SeenPixels &seen, const cv::Size &size);

  /** What two maps of one size both show. */
  SeenPixels both_seen(const SeenPixels &a, const SeenPixels &b);

  /** Takes what is not seen out of @p mask (CV_8U). */
  void keep_seen(cv::Mat &mask, const SeenPixels &seen);

  /**
   * What a black border of @p grey (CV_32F) leaves, as it remains where an
   * image was turned or put together: blocks of at least 9 x 9 pixels that are
   * exactly 0 and reach the edge of the image. Empty where they are less than
   * half a per cent of the image.
   */
  SeenPixels inside_black_border(const cv::Mat &grey);

  /**
   * @p grey (CV_32F) with each pixel that is not seen replaced by the one that
   * lies as far behind the edge of what is seen: no edge appears there and the
   * texture goes on. @p seen must hold a pixel.
   */
  cv::Mat mirrored_beyond(const cv::Mat &grey, const SeenPixels &seen);
} // namespace squeal::tribology

#endif
