// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_images_image_size_h
#define squeal_tribology_images_image_size_h

#include <squeal/tribology/setup/image_parameters.h>

#include <cstdint>
#include <optional>
#include <string>

namespace squeal::tribology
{
  /** What the header of an image file promises. */
  struct ImageSize
  {
    std::uint64_t width = 0, height = 0; /**< pixels */

    double n_pixels() const;
  };

  /** Bytes that reading and segmenting an image take for each of its pixels:
   * 112 were measured on one full of dark lines, 49 on one without. */
  constexpr double bytes_per_pixel = 120.;

  /**
   * Width and height from the first bytes of a PNG, TIFF, JPEG or BMP file,
   * without decoding it; nothing for any other file and for a damaged header.
   */
  std::optional<ImageSize> image_size(const std::string &data);

  /**
   * Refuses an image that would not fit before it is decoded: a small file can
   * hold a large one. Throws InputError, one line with @p path, the size and
   * the memory that it takes, when it has more than @p largest million pixels
   * or needs more than the memory that is available.
   */
  void require_room(const std::string &path,
                    const ImageSize   &size,
                    double             largest = usual_largest_image);
} // namespace squeal::tribology

#endif
