// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_images_line_position_h
#define squeal_tribology_images_line_position_h

#include <opencv2/core.hpp>

namespace squeal::tribology
{
  /**
   * Moves a skeleton to the middle of the dark lines that it follows.
   *
   * The crest of an oriented filter lies on the centre of a line only within
   * the steps of its directions, and a thinned crest wiggles by its staircase.
   * So each edge between junctions and ends is smoothed and moved across
   * itself, twice by up to 2.5 pixels: its offsets are those of least mean
   * brightness in the image smoothed by about half the width of a thin line,
   * with a penalty on their change from pixel to pixel, so that grains beside
   * the line do not draw it aside. The brightness counts in units of the mean
   * depth of the line, the least sum is found by dynamic programming. Between
   * flanks of unlike brightness the result lies towards the darker one, by 0.4
   * pixels where they differ by a quarter of the depth of a line of 1.5 pixels.
   * Junctions move by the mean of the edges that meet in them. Rings stay.
   *
   * @p grey is CV_32F, @p centre_line a skeleton, CV_8U, 0 or 255. The result
   * is a skeleton with the same branches.
   */
  cv::Mat move_to_middle(const cv::Mat &grey, const cv::Mat &centre_line);
} // namespace squeal::tribology

#endif
