// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_images_line_features_h
#define squeal_tribology_images_line_features_h

#include <squeal/tribology/images/centre_line.h>
#include <squeal/tribology/images/ridge_filter.h>

#include <array>
#include <vector>

namespace squeal::tribology
{
  /** What is measured along a dark line. Lengths in pixels; contrasts in units
   * of noise unless they are said to be relative to a brightness. */
  enum class LineFeature
  {
    contrast,         /**< mean of RidgeField::local */
    path,             /**< mean of RidgeField::strength */
    coarse_path,      /**< mean of RidgeField::coarse */
    peak_contrast,    /**< logarithm of the median without limit */
    weak_contrast,    /**< lower quartile of RidgeField::local */
    darkness,         /**< mean, relative to the darker flank */
    weak_darkness,    /**< lower quartile */
    length,           /**< logarithm */
    waviness,         /**< distance from a straight line over the length */
    straight_run,     /**< logarithm of 1 + straight_run() / 20 */
    asymmetry,        /**< difference of the flanks over the depth: light from
                           one side, or the edge of a stain */
    far_asymmetry,    /**< the same 9 pixels away */
    narrowness,       /**< depth against flanks at 2 over that at 4 pixels */
    breadth,          /**< depth against flanks at 6 over that at 4 pixels */
    level,            /**< brightness of the line over that of the image */
    texture,          /**< spread of the brightness around, over the usual */
    clutter,          /**< share of pixels around that are crests */
    parallels,        /**< share of crests around that run alike, others only */
    continuity,       /**< share of pixels at least half as dark as the mean */
    turning,          /**< mean turn over 8 pixels, radians */
    depth_in_texture, /**< depth over the spread of the brightness around */
    depth,            /**< over the brightness of the image */
    lay,              /**< logarithm of how much more the surface changes
                           across the line's direction than across others, when
                           averaged along it: grooves, bright or dark, anywhere
                           in the image; a single line changes nothing */
    groove,           /**< straight_run times lay */
    through           /**< the straight run ends at the border: 0, 1/2, 1 */
  };
  constexpr int n_line_features = int(LineFeature::through) + 1;

  using LineFeatures = std::array<double, n_line_features>;

  /** Measures dark lines of an image (@p grey, CV_32F). The arguments must
   * outlive it. */
  class LineMeter
  {
  public:
    LineMeter(const cv::Mat    &grey,
              const RidgeField &ridges,
              const cv::Mat    &crests);

    /** Features of the pixels @p core of @p piece. */
    LineFeatures measure(const LinePiece &piece, const PixelPath &core) const;

    /** How much darker a pixel is than its darker flank, relative to that. */
    const cv::Mat1f &
    darkness() const
    {
      return dark;
    }

  private:
    float depth_at(const cv::Point &p, double distance) const;
    float difference_at(const cv::Point &p, double distance) const;
    float smooth_at(const cv::Point &p) const;
    void  count_crests();
    void  measure_lay();
    void  measure_darkness();
    void  measure_profile(const PixelPath &core, LineFeatures &f) const;
    void  measure_surroundings(const PixelPath &core, LineFeatures &f) const;
    void  measure_shape(const LinePiece &piece,
                        const PixelPath &core,
                        LineFeatures    &f) const;

    const RidgeField &ridges;
    const cv::Mat    &crests;
    cv::Mat1f         smooth, dark, texture, clutter;
    std::array<cv::Mat1f, RidgeField::n_directions> alike; // at a quarter
    std::vector<double>                             lay;   /**< by direction */
    double bulk = 1., usual_texture = 1.;
  };
} // namespace squeal::tribology

#endif
