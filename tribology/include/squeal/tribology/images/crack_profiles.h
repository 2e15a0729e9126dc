// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_images_crack_profiles_h
#define squeal_tribology_images_crack_profiles_h

#include <squeal/tribology/images/centre_line.h>
#include <squeal/tribology/images/crack_depth.h>

#include <opencv2/core.hpp>

#include <vector>

namespace squeal::tribology
{
  /** Pixels to each side along a line over which a profile across it is
   * averaged. */
  constexpr int profile_along = 3;

  /** Where the middle of a dip is no darker than that, the picture shows no
   * line: twice what texture and noise give. */
  constexpr double least_peak = 0.06;

  /** The middle one of @p values, of which there must be some. */
  float middle_value(std::vector<float> values);

  /** A dip, and the deviation of its missing light by what lies beside it,
   * pixels. */
  struct MeasuredDip
  {
    Dip    dip;
    double doubt = 0.;
  };

  /**
   * The dips at the pixels of @p crack, in their order. How far a profile
   * reaches is the same for all of them: texture would else be taken in where
   * it is dark and left out where it is bright, and a narrow crack look wider.
   *
   * The flank, beside which the light is missing, lies beyond the half width by
   * as much again (at most 5.25 pixels) and 1.5 pixels, and is the mean over 4
   * pixels. It ends half way to the next of @p lines, or where the mean profile
   * of the crack falls again. A side on which less than 2 pixels are left
   * beside the crack takes the brightness of the other one. What both sides
   * differ by is then doubtful.
   *
   * @p grey is CV_32F, @p lines (CV_8U) are all centre lines, @p direction
   * (CV_32F, radians) is that of the crack at its pixels. Bands that are too
   * wide for a profile of 16 pixels are looked for up to a half width of
   * @p largest_half pixels. Throws nothing.
   */
  std::vector<MeasuredDip> dips_along(const cv::Mat   &grey,
                                      const cv::Mat   &lines,
                                      const LinePiece &crack,
                                      const cv::Mat   &direction,
                                      double           largest_half);
} // namespace squeal::tribology

#endif
