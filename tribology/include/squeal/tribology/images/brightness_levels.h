// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_images_brightness_levels_h
#define squeal_tribology_images_brightness_levels_h

#include <squeal/tribology/images/seen_pixels.h>

namespace squeal::tribology
{
  /** What the histogram of a picture says about its bulk. */
  struct BrightnessLevels
  {
    double bulk      = 0.; /**< the level of the surface */
    double deviation = 0.; /**< of the peak of the bulk */
    /** Where a second peak lies above the most frequent value, both of them,
     * and the share of the pixels below the valley between them; else the
     * share is 0. */
    double darker = 0., brighter = 0., darker_share = 0.;

    bool
    are_two() const
    {
      return darker_share > 0.;
    }

    bool
    bulk_is_darker() const
    {
      return bulk == darker;
    }
  };

  /**
   * Levels of @p values (CV_32F, -1 to 4), where something is @p seen. The
   * bulk is the most frequent value, with the deviation of the peak around it
   * from its width at six tenths of its height. The even floor of pits has the
   * narrower and so the higher peak even where it is the smaller part: a peak
   * above it that stands apart and has more of the pixels is the bulk instead.
   */
  BrightnessLevels levels_of(const cv::Mat1f &values, const SeenPixels &seen);

  /**
   * Whether @p levels are those of two areas with a rim between them: the
   * darker is less bright by at least @p least_contrast, and between 2 and 4.5
   * pixels on both sides of the outlines the brightness steps by most of the
   * difference. @p smooth (CV_32F) tells the sides, @p fine the step; both are
   * brightness over that of the bulk, minus 1.
   */
  bool have_rim_between(const BrightnessLevels &levels,
                        const cv::Mat1f        &smooth,
                        const cv::Mat1f        &fine,
                        double                  least_contrast,
                        const SeenPixels       &seen = {});
} // namespace squeal::tribology

#endif
