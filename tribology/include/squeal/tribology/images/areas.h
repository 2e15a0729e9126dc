// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_images_areas_h
#define squeal_tribology_images_areas_h

#include <squeal/tribology/images/seen_pixels.h>

#include <vector>

namespace squeal::tribology
{
  /** @p grey over its shading, minus 1, so that the bulk of the surface (its
   * most frequent brightness, see levels_of()) is 0. The shading is a
   * polynomial of second degree whose slopes are fitted robustly to those of
   * the logarithm: areas of other brightness disturb at their edges only. Both
   * are those of what is
   * @p seen; of strips too narrow to tell a shading there is none. */
  cv::Mat flatten_illumination(const cv::Mat    &grey,
                               const SeenPixels &seen = {});

  /** Exfoliations and contact plateaus. */
  struct AreaMap
  {
    cv::Mat exfoliation; /**< CV_8U, 255 inside */
    cv::Mat rough;       /**< CV_8U, the exfoliations that are rough as well */
    cv::Mat plateau;     /**< CV_8U, 255 inside */
    cv::Mat unsettled;   /**< CV_8U, dark areas for which nothing but their
                            brightness speaks; empty where people drew the
                            areas */
    /** Where the brightness has two levels with a rim between them and the
     * darker is the more frequent: its share of what is seen, else 0. */
    double darker_share   = 0.;
    bool   bulk_is_darker = false; /**< and has the larger part: whether it is
                                      the surface or came off is open */
    double exfoliation_error = 0.; /**< deviation of the area, pixels */
    double plateau_error     = 0.; /**< the same; plateaus have no rims, so
                                      that it is no less than their area */
  };

  struct AreaSettings
  {
    double smallest_area   = 60.;  /**< pixels; smaller areas are grains */
    double dark_contrast   = 0.12; /**< of the bulk's brightness */
    double bright_contrast = 0.07; /**< of the bulk's brightness */
  };

  /**
   * Areas darker than the bulk (see levels_of()) that have a rim are
   * exfoliations, see take_without_rim(), areas that are brighter and no
   * rougher than the bulk are plateaus. Both thresholds are absolute contrasts
   * and at least three deviations of the smoothed bulk. Thin dark lines (@p
   * cracks, CV_8U) are taken out before. No area lies where nothing
   * is @p seen.
   */
  AreaMap find_areas(const cv::Mat      &grey,
                     const cv::Mat      &cracks,
                     const AreaSettings &settings = {},
                     const SeenPixels   &seen     = {});

  /** Area of each connected part of @p mask, largest first: the sum of
   * @p pixel_areas, or the number of pixels where they are empty. */
  std::vector<double> part_areas(const cv::Mat   &mask,
                                 const cv::Mat1d &pixel_areas = {});
} // namespace squeal::tribology

#endif
