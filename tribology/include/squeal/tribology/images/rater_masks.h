// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_images_rater_masks_h
#define squeal_tribology_images_rater_masks_h

#include <squeal/tribology/images/micrograph.h>

#include <string>
#include <vector>

namespace squeal::tribology
{
  /** A file with what one rater marked in one image. */
  struct RaterMask
  {
    std::string path;
    std::string rater; /**< what the name adds to that of the image, else the
                            folder */
  };

  /**
   * Gives each mask to the image whose stem its own begins with, followed by
   * nothing or by no letter or digit: @p images are the paths of the images,
   * the result has the masks of each. Of several such images that with the
   * longest stem has it. Throws InputError naming a mask that belongs to no
   * image, and two that would be the same rater of one image. The same where a
   * mask is as well named after another image: one in the folder of its own
   * that is not among @p images, or one that nobody else's mask tells of (of
   * the masks a_anna and a_2_anna the second may be of an image a_2).
   */
  std::vector<std::vector<RaterMask>> assign_masks(
    const std::vector<std::string> &masks,
    const std::vector<std::string> &images);

  /**
   * The marked pixels of the frame of @p image, CV_8U, 255 where marked.
   * @p value is that of marked pixels; -1: the larger of the two values in the
   * file; a file of zeros marks nothing. In a layer that is transparent in part
   * what is opaque is marked, in whatever colour, or of that what has @p value;
   * one that is transparent everywhere marks nothing. The file has the size of
   * the image or of its frame. Throws InputError naming the file when it has
   * another size or is turned by another orientation tag, when it has more than
   * two values (in a layer: one) and @p value is -1, when no pixel has @p value
   * although others are not 0, and when more than half of the pixels are
   * marked: the mask is inverted.
   */
  cv::Mat read_mask(const std::string &path,
                    const Micrograph  &image,
                    int                value,
                    double             largest);
} // namespace squeal::tribology

#endif
