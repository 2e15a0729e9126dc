// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_images_area_evidence_h
#define squeal_tribology_images_area_evidence_h

#include <squeal/tribology/images/seen_pixels.h>

namespace squeal::tribology
{
  /** Areas for which nothing but their brightness speaks. */
  struct AreasWithoutRim
  {
    cv::Mat taken;        /**< CV_8U */
    double  cut_off = 0.; /**< pixels: of the areas that stay, those that the
                             border of the image cuts, each times twice the
                             share of its outline there */
  };

  /**
   * Takes those parts out of @p areas (CV_8U) for which nothing but their
   * brightness speaks, and returns them. A piece that came off leaves a rim:
   * the brightness steps at its outline by most of its depth. Shading and
   * stains fade out, bands of grooves are long for their thickness, and of a
   * dark place that lies along the border of the image the other side is not
   * seen.
   *
   * @p flat is the brightness over the shading (CV_32F), @p lines (CV_8U) are
   * left out of every mean; @p least_step is the least step at a rim. Where
   * what is @p seen ends, there is a border as well.
   */
  AreasWithoutRim take_without_rim(cv::Mat          &areas,
                                   const cv::Mat1f  &flat,
                                   const cv::Mat    &lines,
                                   double            least_step,
                                   const SeenPixels &seen = {});

  /** Length of all outlines of @p areas inside of what is @p seen of the image,
   * pixels. */
  double outline_length(const cv::Mat &areas, const SeenPixels &seen = {});
} // namespace squeal::tribology

#endif
