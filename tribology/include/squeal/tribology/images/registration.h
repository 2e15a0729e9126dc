// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_images_registration_h
#define squeal_tribology_images_registration_h

#include <squeal/tribology/images/micrograph.h>
#include <squeal/tribology/setup/image_parameters.h>

#include <vector>

namespace squeal::tribology
{
  /** A map from pixels of an image to um on the pad (centre at 0, x and y as
   * those of the contact). */
  struct Placement
  {
    cv::Matx33d to_pad   = cv::Matx33d::eye();
    double      residual = 0.; /**< um, rms over the points */

    cv::Point2d operator()(const cv::Point2d &pixel) const;
  };

  /** Share of a view of @p size (pixels), by its area on the pad, that lies on
   * a pad with edges @p pad (um) about the origin: 0 to 1. */
  double share_on_pad(const cv::Size   &size,
                      const Placement  &placement,
                      const cv::Size2d &pad);

  /** What a placement makes of a pixel: its edges on the pad, um. */
  struct PixelOnPad
  {
    cv::Point2d u, v;

    PixelOnPad(const Placement &placement, const cv::Point2d &pixel);

    /** um^2 */
    double area() const;

    /** Of a step of one pixel in a direction of the image, radians. */
    cv::Point2d step(double direction) const;

    /** The longest step of one pixel over the shortest: 1 for a square. */
    double stretch() const;
  };

  /**
   * Least squares over pairs of points: similarity and affine map (3 points
   * or more) or homography (4). Throws InputError when there are too few or
   * when they lie on one line, where affine maps and homographies do not exist
   * and a mirrored similarity cannot be told.
   */
  Placement fit_placement(const std::vector<cv::Point2d>   &pixels,
                          const std::vector<cv::Point2d>   &pad,
                          SegmentationParameters::Transform kind);

  /** The frame's centre at its stage position, rows along y. Throws InputError
   * when its metadata has none. */
  Placement place_by_stage(const Micrograph &micrograph);

  /** An image as it lies on the pad, in the axes that maps are drawn in: x to
   * the right, y upwards. */
  struct PadView
  {
    cv::Mat     image;           /**< white beside the frame */
    cv::Point2d upper_left;      /**< um on the pad: least x, largest y */
    double      pixel_size = 0.; /**< um */
  };

  /** Turns and mirrors @p image (the frame that @p placement is of, 8 bit) into
   * the axes of the pad; pixels keep their size on the mean. */
  PadView in_axes_of_pad(const cv::Mat &image, const Placement &placement);
} // namespace squeal::tribology

#endif
