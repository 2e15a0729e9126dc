// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_images_segmentation_h
#define squeal_tribology_images_segmentation_h

#include <squeal/tribology/images/areas.h>
#include <squeal/tribology/images/crack_finder.h>

namespace squeal::tribology
{
  /** Everything found in one image. */
  struct Segmentation
  {
    CrackMap                  cracks;
    AreaMap                   areas;
    std::vector<ExcludedLine> excluded; /**< dark lines that are no cracks */
    /** Cracks, or a few dark rows of the scan: see without_scan_rows(). */
    std::vector<PixelPath> rows_like_scan;
    SeenPixels             seen; /**< what the figures are of */
  };

  struct SegmentationSettings
  {
    int          n_octaves = 2; /**< see filter_ridges() */
    AreaSettings areas;
  };

  /** Cracks, exfoliations and plateaus of @p grey (CV_32F, 0 to 255). A dark
   * line inside an exfoliation is part of its roughness, no crack. Where
   * nothing is @p seen the grey values may be any: they are not looked at. */
  Segmentation segment(const cv::Mat              &grey,
                       const SegmentationSettings &settings = {},
                       const LineJudge  &judge = LineJudge::standard(),
                       const SeenPixels &seen  = {});
} // namespace squeal::tribology

#endif
