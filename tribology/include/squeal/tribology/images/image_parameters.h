// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_images_image_parameters_h
#define squeal_tribology_images_image_parameters_h

#include <string>
#include <vector>

namespace squeal
{
  namespace prm
  {
    class Schema;
  }

  namespace tribology
  {
    /** Which images are read and their scale, section "Images". */
    struct ImageParameters
    {
      std::vector<std::string> images; /**< files or wildcards */
      double pixel_size = 0.; /**< m; 0: from the image's own metadata */
    };

    /** Crack, exfoliation and plateau maps, section "Segmentation". */
    struct SegmentationParameters
    {
    };

    /** Images that are made, section "Synthetic specimen". */
    struct SpecimenParameters
    {
    };

    /** Declares the three sections. */
    void declare_images(prm::Schema            &schema,
                        ImageParameters        &images,
                        SegmentationParameters &segmentation,
                        SpecimenParameters     &specimen);

    /** @name Checks that span several entries; each throws InputError. */
    //@{
    void check_segmentation(const ImageParameters        &images,
                            const SegmentationParameters &segmentation);
    void check_specimen(const ImageParameters    &images,
                        const SpecimenParameters &specimen);
    //@}
  } // namespace tribology
} // namespace squeal

#endif
