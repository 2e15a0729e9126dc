// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_images_mosaic_h
#define squeal_tribology_images_mosaic_h

#include <squeal/tribology/images/registration.h>

#include <string>
#include <vector>

namespace squeal::tribology
{
  /** Frames joined to one image. */
  struct Mosaic
  {
    cv::Mat                  grey; /**< CV_32F, the mean where frames overlap */
    SeenPixels               seen; /**< what one frame at least shows */
    std::vector<cv::Point2d> shifts;        /**< px, of each frame */
    int                      n_tried   = 0; /**< overlaps wide enough */
    int                      n_refined = 0; /**< of these, those that match
                                                 as the frames are placed */
    double correction = 0.;                 /**< px, largest of a place */
    /** What is odd about overlaps, for the log. */
    std::vector<std::string> warnings;
  };

  /** Joins what is seen in frames of one pixel size by stage positions, refined
   * pair by pair on their overlaps. A tree of overlaps places the frames, those
   * that show anything first and of these those of the largest area by the
   * stage, whatever the order of the frames; the first frame stays where it is.
   * Every other overlap is held against these places. Warns of frames that do
   * not match there, that are brighter or darker than their neighbour and that
   * hardly overlap. Throws InputError when a frame has no stage position, the
   * scales differ, the result would be larger than require_room() allows or
   * more than half of the overlaps that show anything do not match, all
   * together or along one of the axes.
   */
  Mosaic join_frames(const std::vector<Micrograph> &frames,
                     double largest = usual_largest_image);
} // namespace squeal::tribology

#endif
