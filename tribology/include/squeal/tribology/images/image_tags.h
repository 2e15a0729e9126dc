// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_images_image_tags_h
#define squeal_tribology_images_image_tags_h

#include <optional>
#include <string>

namespace squeal::tribology
{
  /** What the tags of an image file say of its pixels. */
  struct ImageTags
  {
    int orientation = 1;     /**< tag 274, of TIFF or of the EXIF of PNG and
                                  JPEG; 1: upright */
    int  n_images       = 1; /**< pages of a TIFF that are no smaller copies */
    bool white_is_zero  = false; /**< tag 262 of TIFF */
    bool may_have_alpha = false; /**< an alpha channel or transparent colours */
    bool has_extra_samples = false; /**< tag 338 of TIFF: alpha or others */
    /** The grey value of a grey PNG that is transparent: 0 to 255, or to 65535
     * in one of 16 bits. */
    std::optional<int> transparent_grey;
  };

  /** Reads the tags in the bytes of a PNG, TIFF or JPEG file; of any other file
   * and where there are none they are as above. */
  ImageTags image_tags(const std::string &data);
} // namespace squeal::tribology

#endif
