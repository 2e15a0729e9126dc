// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_images_statistics_h
#define squeal_tribology_images_statistics_h

#include <squeal/tribology/images/registration.h>
#include <squeal/tribology/images/segmentation.h>

#include <vector>

namespace squeal::tribology
{
  /** Figures of one image; angles against the sliding direction. */
  struct ImageStatistics
  {
    static constexpr int n_orientations = 12;

    double observed_area = 0.; /**< mm^2 */
    int    n_cracks      = 0;  /**< connected */
    double crack_length  = 0.; /**< mm */
    double crack_density = 0.; /**< mm per mm^2 */
    double crack_area    = 0.; /**< mm^2 */
    double crack_width   = 0.; /**< um, mean along the length */
    /** Deviations: length by its pixels, its ends and what is usually missed
     * or invented; width by the depth of cracks; area by both. */
    double crack_length_error = 0.; /**< mm */
    /** Part of it (in squares) that errs to one side in all images of a run:
     * what the finder and the rules of a length do, but not where single lines
     * end and how far raters differ. */
    double              crack_length_common_error = 0.; /**< mm */
    double              crack_area_error          = 0.; /**< mm^2 */
    double              crack_width_error         = 0.; /**< um */
    std::vector<double> orientation; /**< length share in bins of 15 degrees
                                        from 0 (along the sliding direction) */
    double exfoliation_fraction = 0.;
    /** Deviations: outlines, dark places without a rim, how far raters differ;
     * that of the plateaus is no less than their share, as nothing but their
     * brightness speaks for them. */
    double exfoliation_fraction_error = 0., plateau_fraction_error = 0.;
    /** Dark places without a rim: shading, stains or exfoliations. */
    double unsettled_fraction = 0.;
    /** Share of the darker of two levels of brightness; 0: they are not two.
     * See AreaMap. */
    double              darker_level_fraction = 0.;
    bool                bulk_is_darker        = false;
    std::vector<double> exfoliation_areas; /**< um^2, largest first */
    double              plateau_fraction = 0.;
    std::vector<double> plateau_areas; /**< um^2, largest first */

    /** Whether the area of exfoliations is more than two deviations, so that
     * there are some. */
    bool
    shows_exfoliations() const
    {
      return exfoliation_fraction > 2. * exfoliation_fraction_error;
    }
  };

  /** Errors of the sum of the lengths of several images, mm: common parts add
   * up, the others in squares. */
  struct SummedLengthError
  {
    double common = 0., square = 0.; /**< mm, mm^2 of the others */

    void add(const ImageStatistics &image);

    /** Of which the images show each part of the pad once, and so much of what
     * they show is @p share: the same image n times has the error of one. */
    double deviation(double share = 1.) const;
  };

  /** The areas of the pixels of an image on the pad. */
  struct PixelAreas
  {
    cv::Mat1d of_pixels; /**< um^2 */
    double    seen = 0.; /**< um^2, of all that are seen */

    PixelAreas(const Segmentation &segmentation, const Placement &placement);

    /** um^2, of the pixels of @p mask (CV_8U, may be empty). */
    double of(const cv::Mat &mask) const;
  };

  /** Figures on the pad, to which @p placement takes the pixels: lengths, widths
   * and directions follow the pixels where they are no squares. @p sliding is
   * the direction there, radians from x towards y. */
  ImageStatistics measure(const Segmentation &segmentation,
                          const Placement    &placement,
                          double              sliding);

  /** The same of square pixels of @p pixel_size (um), x along the rows. */
  ImageStatistics measure(const Segmentation &segmentation,
                          double              pixel_size,
                          double              sliding);

  /** Length on the pad, um, of a line of which the pixels are known. */
  double length_on_pad(const PixelPath &line, const Placement &placement);

  /** The picture with cracks in red, exfoliations outlined in magenta, dark
   * places without a rim in grey and plateaus in blue (CV_8UC3). */
  cv::Mat draw_overlay(const cv::Mat &grey, const Segmentation &segmentation);
} // namespace squeal::tribology

#endif
