// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_images_section_profile_h
#define squeal_tribology_images_section_profile_h

#include <squeal/tribology/images/seen_pixels.h>

#include <string>
#include <vector>

namespace squeal::tribology
{
  /** A section through a pad, worn face at the top. Lengths in pixels. */
  struct SectionProfile
  {
    std::vector<double> surface; /**< row of the face in each column */
    std::vector<double> layer;   /**< thickness in each column; 0: none */
    double              layer_median = 0.;
    double              layer_10     = 0.; /**< 10th percentile */
    double              layer_90     = 0.; /**< 90th percentile */
    std::vector<double> crack_length;      /**< in each band of depth */
    std::vector<double> band_area;         /**< of what is seen of it */
    std::vector<double> band_depth; /**< mean of what is seen; 0: nothing is */
    /** What brightness alone cannot decide, a sentence each: whether the face
     * is seen, and whether a dark strip above it is resin or a layer. */
    std::vector<std::string> doubts;
  };

  /**
   * Face, third-body layer and cracks against depth. The face is where the
   * dark mounting resin ends. Of two dark strips one above the other the upper
   * one is the resin, the lower one the layer. The layer is what lies under the
   * face with another brightness than the bulk below: its end is where the
   * smoothed
   * column has gone half the way between the two. Bands reach from the face to
   * the deepest pixel; the last one may be incomplete. @p grey CV_32F,
   * @p centre_line CV_8U, @p band pixels; bands are of what is @p seen.
   */
  SectionProfile profile_section(const cv::Mat    &grey,
                                 const cv::Mat    &centre_line,
                                 double            band,
                                 const SeenPixels &seen = {});

  /** A picture of a section without its resin. */
  struct SectionView
  {
    /** CV_32F; above the face, and in the blurred edge under it, the mirror
     * image of what is deeper. */
    cv::Mat    grey;
    SeenPixels seen; /**< from the face down */
  };

  /** What of @p grey (CV_32F) lies under the face that profile_section() finds
   * and is @p seen. Empty where that is nothing. */
  SectionView below_face(const cv::Mat &grey, const SeenPixels &seen = {});
} // namespace squeal::tribology

#endif
