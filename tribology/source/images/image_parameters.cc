// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/parameters/checks.h>
#include <squeal/parameters/schema.h>
#include <squeal/tribology/images/image_parameters.h>

namespace squeal::tribology
{
  void
  declare_images(prm::Schema     &schema,
                 ImageParameters &images,
                 SegmentationParameters &,
                 SpecimenParameters &)
  {
    schema.enter_section("Images", "Micrographs and their scale.");
    schema.add("Images",
               images.images,
               prm::Allowed::list(prm::Allowed::file()),
               "Image files; * and ? stand for any letters.");
    schema.add("Pixel size",
               images.pixel_size,
               prm::Allowed::number(0.),
               "Edge of a pixel; 0: from the metadata of each image.",
               "m");
    schema.leave_section();
  }



  void
  check_segmentation(const ImageParameters &images,
                     const SegmentationParameters &)
  {
    if (images.images.empty())
      prm::refuse_entry("Images", "Images", "is empty: name image files");
  }



  void
  check_specimen(const ImageParameters &, const SpecimenParameters &)
  {
  }
} // namespace squeal::tribology
