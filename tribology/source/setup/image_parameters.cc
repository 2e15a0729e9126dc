// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/parameters/checks.h>
#include <squeal/parameters/schema.h>
#include <squeal/tribology/setup/image_parameters.h>
#include <squeal/tribology/setup/unused_entries.h>

namespace squeal::tribology
{
  namespace
  {
    using prm::Allowed;
    const char *const segmentation_section = "Segmentation";
    const char *const specimen_section     = "Synthetic specimen";

    void
    declare_masks(prm::Schema &schema, SegmentationParameters &s)
    {
      schema.add("Masks",
                 s.masks,
                 Allowed::list(Allowed::file()),
                 "Images in which people or other programs (Fiji, ilastik) "
                 "marked cracks, 8 or 16 bit; * and ? stand for any letters. "
                 "The name of a mask begins with that of its image; several "
                 "masks of an image are several raters. On a transparent layer "
                 "what is opaque is marked.");
      schema.add("Area masks",
                 s.area_masks,
                 Allowed::list(Allowed::file()),
                 "The same for exfoliations, breaks and blowholes.");
      schema.add("Mask use",
                 s.mask_use,
                 "What is stated: the masks (what at least half of the raters "
                 "marked) instead of squeal's own finding, or squeal's own "
                 "with the masks beside it as other raters. How far raters "
                 "differ is part of the stated error in both cases.");
      schema.add("Mask value",
                 s.mask_value,
                 Allowed::integer(-1, 65535),
                 "Value of marked pixels in masks; -1: the larger one of two.");
      schema.add("Mask tolerance",
                 s.mask_tolerance,
                 Allowed::number(0., 50.),
                 "Lines of two raters that lie as far apart are the same "
                 "line.",
                 "pixels");
    }



    void
    declare_segmentation(prm::Schema &schema, SegmentationParameters &s)
    {
      schema.enter_section(segmentation_section,
                           "Cracks, exfoliations and plateaus in images.");
      schema.add("View",
                 s.view,
                 "The worn face, or a section with the worn face at the top: "
                 "cracks and third-body layer against depth.");
      schema.add("Sliding direction",
                 s.sliding_direction,
                 Allowed::number(0., 180.),
                 "In the image, from its x axis towards its y axis, which "
                 "points down; with 'Registration' on the pad, from x towards "
                 "y.",
                 "degrees");
      schema.add("Largest crack width",
                 s.largest_width,
                 Allowed::number(0.),
                 "Widest dark line that is looked for; 0: 9 pixels. Cracks "
                 "wider than about 10 pixels are mostly not found: give the "
                 "image with larger pixels, or mark them in 'Masks'.",
                 "um");
      schema.add("Smallest area",
                 s.smallest_area,
                 Allowed::number(0.),
                 "Smallest exfoliation or plateau; 0: 60 pixels.",
                 "um^2");
      schema.add("Cells",
                 s.cells,
                 Allowed::list(Allowed::integer(1, 1000), 2, 2),
                 "Cells along x and y over the pad, or over the image when it "
                 "is not registered.");
      schema.add("Pad size",
                 s.pad_size,
                 Allowed::list(Allowed::positive(), 2, 2),
                 "Edges of the pad along x and y; its centre is the origin.",
                 "mm");
      schema.add("Registration",
                 s.registration,
                 "How images lie on the pad: not known, by the stage position "
                 "in their metadata, or by points known in image and pad.");
      schema.add(
        "Transform", s.transform, "What takes image points to pad points.");
      schema.add("Image points",
                 s.image_points,
                 Allowed::list(Allowed::number()),
                 "x and y of each point in turn.",
                 "pixels");
      schema.add("Pad points",
                 s.pad_points,
                 Allowed::list(Allowed::number()),
                 "x and y of the same points in turn.",
                 "mm");
      schema.add("Scale bar box",
                 s.scale_bar_box,
                 Allowed::list(Allowed::integer(0), 0, 4),
                 "x, y, width and height of a box around the scale bar, "
                 "wider than the bar.");
      schema.add("Scale bar length",
                 s.scale_bar_length,
                 Allowed::number(0.),
                 "What the bar stands for; 0: no bar is used.",
                 "um");
      schema.add("Data bar",
                 s.data_bar,
                 Allowed::integer(-1),
                 "Rows at the bottom of each image that are no picture; -1: "
                 "found by their even background, which the log tells.",
                 "pixels");
      schema.add(
        "Mosaic",
        s.mosaic,
        "Join all images to one by their stage positions. What none of them "
        "shows is no area.");
      schema.add("Depth band",
                 s.depth_band,
                 Allowed::positive(),
                 "Thickness of the layers of the crack profile of a section.",
                 "um");
      schema.add("Element maps",
                 s.element_maps,
                 Allowed::list(Allowed::file()),
                 "Element maps, grey images, of the same view as the first "
                 "image or, with 'Mosaic', as all of them joined; the mean of "
                 "each cell becomes a column named like the file.");
      declare_masks(schema, s);
      schema.leave_section();
    }



    void
    declare_specimen(prm::Schema &schema, SpecimenParameters &s)
    {
      schema.enter_section(specimen_section,
                           "Images with known cracks and exfoliations.");
      schema.add("Number of images",
                 s.n_images,
                 Allowed::integer(1, 1000),
                 "Images with seeds that follow each other.");
      schema.add("Seed", s.seed, Allowed::integer(0), "Seed of the first.");
      schema.add("Field",
                 s.field,
                 Allowed::list(Allowed::positive(), 2, 2),
                 "Width and height of the view.",
                 "um");
      schema.add("Feature size",
                 s.feature_size,
                 Allowed::positive(),
                 "Multiplies every length of a feature.");
      schema.add("Crack density",
                 s.crack_density,
                 Allowed::number(0.),
                 "Number of cracks for each unit of area, at feature size 1.",
                 "1/mm^2");
      schema.add("Exfoliated",
                 s.exfoliated,
                 Allowed::number(0., 0.5),
                 "Share of the area, about.");
      schema.add("Plateaus",
                 s.plateaus,
                 Allowed::number(0., 0.5),
                 "Share of the area, about.");
      schema.add("Noise",
                 s.noise,
                 Allowed::number(0., 100.),
                 "Rms of the detector's noise in grey levels of 255.");
      schema.add("Shading",
                 s.shading,
                 Allowed::number(0., 1.),
                 "Change of brightness over the view.");
      schema.add("Data bar", s.data_bar, "Add a data bar with a scale bar.");
      schema.add("Damage table",
                 s.damage_table,
                 Allowed::file(),
                 "damage.csv whose map the cracks follow; empty: none.");
      schema.add(
        "Damage column", s.damage_column, Allowed::text(), "Its column.");
      schema.add("Link strength",
                 s.link_strength,
                 Allowed::number(0., 1.),
                 "0: cracks anywhere; 1: their rate is proportional to the "
                 "damage.");
      schema.leave_section();
    }
  } // namespace



  Choices<SegmentationParameters::View>
  choices(SegmentationParameters::View)
  {
    using V = SegmentationParameters::View;
    return {{"face", V::face}, {"section", V::section}};
  }



  Choices<SegmentationParameters::Registration>
  choices(SegmentationParameters::Registration)
  {
    using R = SegmentationParameters::Registration;
    return {{"none", R::none}, {"stage", R::stage}, {"points", R::points}};
  }



  Choices<SegmentationParameters::Transform>
  choices(SegmentationParameters::Transform)
  {
    using T = SegmentationParameters::Transform;
    return {{"similarity", T::similarity},
            {"affine", T::affine},
            {"homography", T::homography}};
  }



  Choices<SegmentationParameters::MaskUse>
  choices(SegmentationParameters::MaskUse)
  {
    using U = SegmentationParameters::MaskUse;
    return {{"instead", U::instead}, {"beside", U::beside}};
  }



  void
  declare_images(prm::Schema            &schema,
                 ImageParameters        &images,
                 SegmentationParameters &segmentation,
                 SpecimenParameters     &specimen)
  {
    schema.add("Images",
               images.images,
               Allowed::list(Allowed::file()),
               "Image files of 8 or 16 bit (PNG, TIFF, JPEG, BMP), one image "
               "a file; * and ? stand for any letters where no file has that "
               "very name.");
    schema.add("Pixel size",
               images.pixel_size,
               Allowed::number(0.),
               "Edge of a pixel; 0: from the scale bar or the metadata of each "
               "image.",
               "um");
    schema.add(
      "Largest image",
      images.largest_image,
      Allowed::positive(),
      "Images with more pixels are refused before they are decoded; "
      "a million pixels take up to 120 MB. One that does not fit into the "
      "memory that is available is refused in any case.",
      "million pixels");
    declare_segmentation(schema, segmentation);
    declare_specimen(schema, specimen);
  }



  namespace
  {
    void
    refuse_unused_entries(const ImageParameters        &images,
                          const SegmentationParameters &s)
    {
      using S = SegmentationParameters;
      const S    otherwise;
      const auto refuse = [](const std::string &entry,
                             const bool         is_set,
                             const bool         is_used,
                             const std::string &condition) {
        refuse_without_effect(
          segmentation_section, entry, is_set, is_used, condition);
      };
      const bool        by_points = s.registration == S::Registration::points;
      const std::string without_points =
        "without 'Registration = points': set that or remove it";
      refuse(
        "Image points", !s.image_points.empty(), by_points, without_points);
      refuse("Pad points", !s.pad_points.empty(), by_points, without_points);
      refuse("Transform",
             s.transform != otherwise.transform,
             by_points,
             without_points);
      refuse("Depth band",
             s.depth_band != otherwise.depth_band,
             s.view == S::View::section,
             "without 'View = section': set that or remove it");
      const bool        by_bar = images.pixel_size == 0.;
      const std::string beside = "beside 'Pixel size': remove one of them";
      refuse("Scale bar length", s.scale_bar_length > 0., by_bar, beside);
      refuse("Scale bar box", !s.scale_bar_box.empty(), by_bar, beside);
      refuse("Scale bar box",
             !s.scale_bar_box.empty(),
             s.scale_bar_length > 0.,
             "without 'Scale bar length': set that or remove "
             "it");
      const bool        has_masks = !(s.masks.empty() && s.area_masks.empty());
      const std::string without_masks =
        "without 'Masks' or 'Area masks': name some or remove it";
      refuse(
        "Mask use", s.mask_use != otherwise.mask_use, has_masks, without_masks);
      refuse("Mask value",
             s.mask_value != otherwise.mask_value,
             has_masks,
             without_masks);
      refuse("Mask tolerance",
             s.mask_tolerance != otherwise.mask_tolerance,
             has_masks,
             without_masks);
    }
  } // namespace



  void
  check_segmentation(const ImageParameters        &images,
                     const SegmentationParameters &s)
  {
    if (images.images.empty())
      prm::refuse_entry("", "Images", "is empty: name image files");
    using R = SegmentationParameters::Registration;
    if (s.registration == R::points &&
        s.image_points.size() != s.pad_points.size())
      prm::refuse_entry(segmentation_section,
                        "Pad points",
                        "must have as many numbers as 'Image points'");
    if (s.scale_bar_length > 0. && s.scale_bar_box.size() != 4)
      prm::refuse_entry(
        segmentation_section, "Scale bar box", "needs x, y, width and height");
    if (s.mosaic && !(s.masks.empty() && s.area_masks.empty()))
      prm::refuse_entry(segmentation_section,
                        "Masks",
                        "are drawn on single images: not with 'Mosaic'");
    refuse_unused_entries(images, s);
    for (const std::string &file : s.element_maps)
      prm::require_file(file, segmentation_section, "Element maps", true);
  }



  void
  check_specimen(const ImageParameters &images, const SpecimenParameters &s)
  {
    const double pixel = images.pixel_size > 0. ? images.pixel_size : 1.;
    for (const double edge : s.field)
      if (edge / pixel < 64. || edge / pixel > 12000.)
        prm::refuse_entry(specimen_section,
                          "Field",
                          "must give between 64 and 12000 pixels: change it "
                          "or 'Pixel size'");
    if (s.link_strength > 0. && s.damage_table.empty())
      prm::refuse_entry(specimen_section,
                        "Damage table",
                        "is empty, but 'Link strength' is not 0");
    const std::string without_link =
      "with 'Link strength = 0', where cracks lie anywhere: set that or remove "
      "it";
    refuse_without_effect(specimen_section,
                          "Damage table",
                          !s.damage_table.empty(),
                          s.link_strength > 0.,
                          without_link);
    refuse_without_effect(specimen_section,
                          "Damage column",
                          !s.damage_column.empty(),
                          s.link_strength > 0.,
                          without_link);
    if (!s.damage_table.empty() && s.damage_column.empty())
      prm::refuse_entry(specimen_section,
                        "Damage column",
                        "is empty: name a column of 'Damage table'");
  }
} // namespace squeal::tribology
