// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_images_ridge_filter_h
#define squeal_tribology_images_ridge_filter_h

#include <squeal/tribology/images/seen_pixels.h>

namespace squeal::tribology
{
  /** Evidence for dark lines. All of the size of the image. */
  struct RidgeField
  {
    static constexpr int n_directions = 16;

    /** CV_32F, contrast along the best path of about 36 pixels through the
     * pixel, in units of the noise of each direction and width at its place. */
    cv::Mat strength;
    /** CV_32F, has its crest on the centre of a line. */
    cv::Mat sharp;
    /** CV_32F, that of the sample at the pixel alone. */
    cv::Mat local;
    /** CV_8U, direction of the best line, in steps of pi / n_directions from
     * +x (right) towards +y (down). */
    cv::Mat direction;
    /** CV_32F, best contrast of any direction and width at the pixel, without
     * limit. */
    cv::Mat unlimited;
    /** CV_32F, as strength at half the resolution: along 72 pixels, of the
     * wider lines alone, so that the grain of the surface averages out. */
    cv::Mat coarse;
    /** Distance of the nearest flanks from a line, pixels. */
    double flank = 0.;

    /** Angle of the line through (x, y), in [0, pi). */
    double angle(const cv::Point &p) const;

    /** The step from (x, y) to the pixel at @p distance across the line. */
    cv::Point across(const cv::Point &p, double distance) const;

    /** The strength is a maximum across the line. */
    bool is_crest(const cv::Point &p) const;
  };

  /**
   * Oriented filters for dark lines of several widths.
   *
   * For each width the image is smoothed, averaged along lines of six standard
   * deviations in 16 directions, and the average is compared with those of the
   * two flanks. A step has one flank only, so the smaller contrast has the
   * larger weight. Contrasts are divided by a robust estimate of their own
   * spread in a neighbourhood of 64 pixels, for each direction and width apart:
   * grooves raise the noise of their own direction and of no other. A flank
   * outside the image proves nothing. The best width of each direction is kept
   * and added up along paths, see integrate_paths(). The second octave is also
   * added up by itself, along paths twice as long.
   *
   * @p grey is CV_32F. What is not @p seen proves nothing. @p narrowest is the deviation of the narrowest filter,
   * pixels. With 1, @p n_octaves 2 reaches lines about 9 pixels wide, each
   * further one doubles that.
   */
  RidgeField filter_ridges(const cv::Mat    &grey,
                           int               n_octaves = 2,
                           double            narrowest = 1.,
                           const SeenPixels &seen      = {});
} // namespace squeal::tribology

#endif
