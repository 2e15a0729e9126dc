// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_setup_image_parameters_h
#define squeal_tribology_setup_image_parameters_h

#include <squeal/parameters/choices.h>

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
    /** Largest image that is read, in million pixels, where nothing else is
     * said. */
    constexpr double usual_largest_image = 100.;

    /** Which images are read and their scale. */
    struct ImageParameters
    {
      std::vector<std::string> images; /**< files or wildcards */
      double pixel_size    = 0.; /**< um; 0: from the image's own metadata */
      double largest_image = usual_largest_image; /**< million pixels */
    };

    /** Crack, exfoliation and plateau maps, section "Segmentation". */
    struct SegmentationParameters
    {
      enum class View
      {
        face,
        section
      };
      enum class Registration
      {
        none,
        stage,
        points
      };
      enum class Transform
      {
        similarity,
        affine,
        homography
      };
      enum class MaskUse
      {
        instead,
        beside
      };
      View                view              = View::face;
      double              sliding_direction = 90.; /**< degrees */
      double              largest_width     = 0.;  /**< um */
      double              smallest_area     = 0.;  /**< um^2 */
      std::vector<int>    cells             = {11, 11};
      std::vector<double> pad_size          = {10., 10.}; /**< mm */
      Registration        registration      = Registration::none;
      Transform           transform         = Transform::similarity;
      std::vector<double> image_points;          /**< px, x and y in turn */
      std::vector<double> pad_points;            /**< mm, x and y in turn */
      std::vector<int>    scale_bar_box;         /**< px: x, y, width, height */
      double              scale_bar_length = 0.; /**< um */
      int    data_bar   = -1; /**< rows at the bottom; -1: found by itself */
      bool   mosaic     = false;
      double depth_band = 10.; /**< um */
      std::vector<std::string> element_maps;
      std::vector<std::string> masks;      /**< of cracks; files or wildcards */
      std::vector<std::string> area_masks; /**< of exfoliations */
      MaskUse                  mask_use       = MaskUse::instead;
      int                      mask_value     = -1; /**< -1: larger of two */
      double                   mask_tolerance = 2.; /**< pixels */
    };

    /** Images that are made, section "Synthetic specimen". */
    struct SpecimenParameters
    {
      unsigned int        n_images      = 1;
      unsigned int        seed          = 1;
      std::vector<double> field         = {1024., 768.}; /**< um */
      double              feature_size  = 1.;
      double              crack_density = 12.; /**< 1/mm^2 */
      double              exfoliated    = 0.05;
      double              plateaus      = 0.15;
      double              noise         = 5.;
      double              shading       = 0.15;
      bool                data_bar      = true;
      std::string         damage_table;
      std::string         damage_column;
      double              link_strength = 0.;
    };

    /** @name Choices in parameter files */
    //@{
    Choices<SegmentationParameters::View> choices(SegmentationParameters::View);
    Choices<SegmentationParameters::Registration> choices(
      SegmentationParameters::Registration);
    Choices<SegmentationParameters::Transform> choices(
      SegmentationParameters::Transform);
    Choices<SegmentationParameters::MaskUse> choices(
      SegmentationParameters::MaskUse);
    //@}

    /** Declares the entries and sections. */
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
