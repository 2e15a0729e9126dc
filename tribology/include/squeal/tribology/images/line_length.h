// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_images_line_length_h
#define squeal_tribology_images_line_length_h

#include <opencv2/core.hpp>

#include <vector>

namespace squeal::tribology
{
  /**
   * Length that each pixel of a skeleton stands for, pixels (CV_32F, 0 off the
   * skeleton). The sum over any part of an image is the length in that part.
   *
   * The skeleton is taken apart into edges between ends and junctions. The
   * pixels of an edge are points of a line, each wrong by its rounding: they
   * are smoothed along the edge, ends and junctions kept, and each pixel gets
   * half of the distance to the next one on both sides. A line covers its last
   * pixel: a free end gets another half step. Touching junction pixels are one
   * node at their centre.
   */
  cv::Mat pixel_lengths(const cv::Mat &skeleton);

  /** The length of a line of which the pixels are known, in any order; pixels.
   */
  double length_of_pixels(const std::vector<cv::Point> &line);
} // namespace squeal::tribology

#endif
