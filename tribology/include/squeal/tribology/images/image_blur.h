// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_images_image_blur_h
#define squeal_tribology_images_image_blur_h

#include <squeal/tribology/images/crack_depth.h>

#include <opencv2/core.hpp>

#include <vector>

namespace squeal::tribology
{
  /** What the profile of a connected crack tells of the blur. */
  struct ProfileShape
  {
    Dip dip; /**< mean along the crack */
    /** Second derivative across the line, smoothed by a Gaussian of a pixel,
     * over that smoothed by two. */
    double curvature_ratio = 0.;
  };

  /** The shape of the crack of @p pixels, of which @p dips are those at the
   * pixels, in their order. @p grey and @p direction (radians) are CV_32F. */
  ProfileShape shape_of_crack(const cv::Mat                &grey,
                              const std::vector<cv::Point> &pixels,
                              const cv::Mat                &direction,
                              const std::vector<Dip>       &dips);

  /**
   * The blur of an image by the shapes of its cracks. Of a box of width w and
   * depth d, blurred by a Gaussian, missing light, peak and ratio of curvatures
   * are three numbers, which follow from w, d and the blur: a wide shallow
   * crack in focus and a narrow deep one out of focus may have the first two
   * alike, not the third. All cracks of an image have one blur. That of a lens
   * in focus is returned where they tell no other. @p bends as in CrackDepth.
   */
  OpticalBlur blur_of_cracks(const std::vector<ProfileShape> &cracks,
                             double                           bends);

  /** Variance of the blur, pixels^2, that the sharpest tenth of the edges of
   * @p grey (CV_32F) have; less than 0 where they are narrow lines. Infinite
   * where less than 1 in 5000 pixels is an edge that stands out of the noise:
   * the image is out of focus, or shows nothing. */
  double sharpest_edges(const cv::Mat &grey);
} // namespace squeal::tribology

#endif
