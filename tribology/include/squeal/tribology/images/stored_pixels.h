// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_images_stored_pixels_h
#define squeal_tribology_images_stored_pixels_h

#include <squeal/tribology/images/image_size.h>

#include <opencv2/core.hpp>

#include <string>

namespace squeal::tribology
{
  /** The pixels of an image file as stored, turned upright where a tag says
   * how the camera was held. */
  struct StoredPixels
  {
    cv::Mat values; /**< grey, CV_8U or CV_16U; 0 is black whatever the file
                         calls black */
    /** CV_8U, 255 where the alpha channel is at least half, or the grey value
     * is not the one that is transparent; empty where there is neither or it is
     * the same everywhere. */
    cv::Mat opaque;
    /** Where that makes every pixel transparent. */
    bool is_transparent = false;
    /** Where values of 16 bits have been taken from 65535, since white is
     * stored as 0. */
    bool is_inverted = false;
    int  orientation = 1; /**< tag 274 of TIFF and EXIF, 1 to 8 */
  };

  /**
   * Pixels of a PNG, TIFF, JPEG or BMP file. Throws InputError naming the file
   * when it is missing, no regular file, empty, truncated, damaged, no image,
   * larger than require_room() allows, of fewer than 32 x 32 pixels, a stack of
   * several images, a grey TIFF with transparency, or turned by a tag and
   * transparent in part.
   */
  StoredPixels read_pixels(const std::string &path,
                           double             largest = usual_largest_image);

  /** StoredPixels::values alone. */
  cv::Mat read_raw(const std::string &path,
                   double             largest = usual_largest_image);
} // namespace squeal::tribology

#endif
