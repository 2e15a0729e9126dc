// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_images_element_map_h
#define squeal_tribology_images_element_map_h

#include <squeal/tribology/images/image_size.h>
#include <squeal/tribology/images/micrograph.h>
#include <squeal/tribology/images/seen_pixels.h>

#include <string>

namespace squeal::tribology
{
  /** The numbers of an element map and where it has any. */
  struct ElementMap
  {
    std::string name;            /**< stem of the file */
    cv::Mat     values;          /**< CV_32F, as stored */
    SeenPixels  seen;            /**< what is opaque */
    int         orientation = 1; /**< tag of the file; values are upright */
  };

  /** An element map as stored. Throws InputError as read_pixels() does, and
   * where the image has colours or is transparent everywhere. */
  ElementMap read_element_map(const std::string &path,
                              double             largest = usual_largest_image);

  /**
   * The element map in @p path with the pixels of the frame of @p image. It may
   * show the data bar or not: the nearer shape tells. Where pixels are put
   * together only opaque ones count, and the sum is opaque where half of it is.
   * Throws InputError as read_element_map() does, and where the map has another
   * shape or another orientation tag than the image: it may lie turned over it.
   */
  ElementMap element_map_over(const Micrograph  &image,
                              const std::string &path,
                              double             largest = usual_largest_image);
} // namespace squeal::tribology

#endif
