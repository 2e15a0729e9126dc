// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_images_ridge_filter_h
#define squeal_tribology_images_ridge_filter_h

#include <opencv2/core.hpp>

namespace squeal::tribology
{
  /** Evidence for dark lines. All of the size of the image. */
  struct RidgeField
  {
    static constexpr int n_directions = 16;

    /** CV_32F, contrast of the best line through the pixel in units of the
     * noise of that line's direction and width at this place. */
    cv::Mat strength;
    /** CV_8U, direction of the best line, in steps of pi / n_directions from
     * +x (right) towards +y (down). */
    cv::Mat direction;

    /** Angle of the line through (x, y), in [0, pi). */
    double angle(const cv::Point &p) const;

    /** The strength is a maximum across the line. */
    bool is_crest(const cv::Point &p) const;
  };

  /**
   * Oriented filters for dark lines of several widths.
   *
   * For each width the image is smoothed, averaged along half lines of six
   * standard deviations in 16 directions, and the average is compared with
   * those of the two flanks. A step has one flank only, so the smaller
   * contrast has the larger weight; a spot fills one half line only, so the
   * weaker half has the larger weight; the two halves may bend by one step.
   * Contrasts are divided by a robust estimate of their own spread in a
   * neighbourhood of 64 pixels, for each direction and width apart: grooves
   * raise the noise of their own direction and of no other. A flank outside
   * the image proves nothing.
   *
   * @p grey is CV_32F. @p n_octaves 2 reaches lines about 9 pixels wide, each
   * further one doubles that.
   */
  RidgeField filter_ridges(const cv::Mat &grey, int n_octaves = 2);
} // namespace squeal::tribology

#endif
