// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_driver_segmentation_input_h
#define squeal_tribology_driver_segmentation_input_h

#include <squeal/tribology/driver/context.h>
#include <squeal/tribology/images/rating.h>

#include <vector>

namespace squeal::tribology
{
  /** What a segmentation reads before it writes anything. */
  struct SegmentationInput
  {
    std::vector<Micrograph>         images;
    std::vector<std::vector<Marks>> crack_marks, area_marks; /**< of each
                                                                 image */
    Placement by_points; /**< of the first image, with 'Registration = points'
                          */

    /** Where the frame of @p image lies on the pad; by itself its middle is the
     * origin. */
    Placement placement_of(const Micrograph             &image,
                           const SegmentationParameters &parameters) const;
  };

  /** Reads images and masks and logs what was made of them. Throws InputError
   * for a file that cannot be read or has no scale, for masks that belong to no
   * image or to two, where registration and scale contradict each other, and
   * for turned images that are to lie by their stage positions. */
  SegmentationInput read_segmentation_input(Context &context);

  /** Warns of an image of which a part lies outside the pad. Throws InputError
   * where nothing lies on it. */
  void check_place(const Micrograph &image,
                   const Placement  &placement,
                   Context          &context);
} // namespace squeal::tribology

#endif
