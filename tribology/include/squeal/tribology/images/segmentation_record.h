// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_images_segmentation_record_h
#define squeal_tribology_images_segmentation_record_h

#include <squeal/results/table.h>
#include <squeal/tribology/images/cell_grid.h>
#include <squeal/tribology/images/rating.h>
#include <squeal/tribology/images/statistics.h>

#include <array>
#include <optional>
#include <string>

namespace squeal::tribology
{
  /** What segmentation.json says of one image. */
  struct SegmentedImage
  {
    std::string                stem, path, scale_source;
    cv::Size                   size;
    double                     pixel_size   = 0.; /**< um */
    bool                       is_synthetic = false;
    std::optional<cv::Point2d> stage;    /**< um */
    std::optional<double>      residual; /**< um */
    ImageStatistics            statistics;
    std::optional<Rating>      crack_rating, area_rating;
    double                     tolerance = 0.; /**< of lines, px */
    std::vector<ExcludedLine>  excluded;
    std::vector<double>        excluded_lengths;           /**< um, of each */
    double                     missed = 0., invented = 0.; /**< expected, px */
    std::optional<std::array<double, 3>> layer; /**< um: 10 %, median, 90 % */
  };

  struct SegmentationRecord
  {
    /** Version of the layout; a reader refuses any other. */
    static constexpr int format_version = 1;

    std::vector<SegmentedImage> images;
    /** Of all images together; nothing where they do not lie on a pad. */
    std::optional<CellGrid::SeenOnce> seen_once;
    std::optional<int>                mosaic_refined;    /**< pairs aligned */
    int                               mosaic_tried = 0;  /**< pairs */
    double mosaic_correction                       = 0.; /**< um, largest */
  };

  /** Writes segmentation.json. Throws ComputationError naming a figure that is
   * not finite. */
  void write_segmentation_record(const SegmentationRecord &record,
                                 const std::string        &path);

  /** A row of main figures for each image. */
  Table summary_table(const SegmentationRecord &record);
} // namespace squeal::tribology

#endif
