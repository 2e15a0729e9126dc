// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_images_section_profile_h
#define squeal_tribology_images_section_profile_h

#include <opencv2/core.hpp>

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
    std::vector<double> band_area;
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
   * column has gone half the way between the two. @p grey CV_32F,
   * @p centre_line CV_8U, @p band pixels.
   */
  SectionProfile profile_section(const cv::Mat &grey,
                                 const cv::Mat &centre_line,
                                 double         band);
} // namespace squeal::tribology

#endif
