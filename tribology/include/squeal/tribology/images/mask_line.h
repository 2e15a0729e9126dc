// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_images_mask_line_h
#define squeal_tribology_images_mask_line_h

#include <opencv2/core.hpp>

#include <vector>

namespace squeal::tribology
{
  /** The line of a mask of cracks. */
  struct MaskLine
  {
    cv::Mat line;           /**< CV_8U, 255 on the skeleton */
    double  end_error = 0.; /**< pixels, deviation of the length by the ends */
    /** Boxes of slender pieces of the mask of whose extent the line reaches
     * over less than a half; there should be none. */
    std::vector<cv::Rect> without_line;
  };

  /**
   * The line of @p mask (CV_8U, 0 or 255), whether lines were drawn in it or
   * cracks were filled: its skeleton, without the branches that rough outlines
   * give (6 pixels, or one and a half times the local half width) and prolonged
   * to the outline at its free ends. A brush of some width goes beyond the end
   * of the crack by half of that, a filled crack does not: half of the half
   * width, less half a pixel, is the deviation of each end. Throws nothing.
   */
  MaskLine line_of_mask(const cv::Mat &mask);
} // namespace squeal::tribology

#endif
