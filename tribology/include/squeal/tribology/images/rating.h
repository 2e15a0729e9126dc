// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_images_rating_h
#define squeal_tribology_images_rating_h

#include <squeal/tribology/images/agreement.h>
#include <squeal/tribology/images/statistics.h>

#include <optional>
#include <string>
#include <vector>

namespace squeal::tribology
{
  /** What one rater marked in an image: masks of its frame, CV_8U. */
  struct Marks
  {
    std::string rater;
    cv::Mat     mask;
  };

  /** Several raters of one image. */
  struct Rating
  {
    std::vector<std::string> raters;
    std::vector<double>      amounts; /**< on the pad: length (um) or area
                                           (um^2) */
    /** Root mean square difference of the raters' amounts from the one that is
     * stated, in the same unit. Missing with one rater: how far raters differ
     * is not known then. */
    std::optional<double>    deviation;
    std::optional<Agreement> agreement; /**< of two or more */
    /** What is wrong with the lines of masks, for the log. */
    std::vector<std::string> warnings;
  };

  /** How masks of people or other programs enter. */
  struct RatingSettings
  {
    bool is_beside = false; /**< squeal is a rater like the others, and its own
                                 finding is stated; else that of the others */
    double    tolerance = 2.; /**< pixels; lines as far apart are the same */
    double    smallest_area = AreaSettings().smallest_area; /**< pixels */
    Placement placement;                                    /**< of the image */
  };

  /**
   * Puts the consensus of @p cracks in the place of the cracks of
   * @p segmentation, or compares them with it. @p grey (CV_32F) is the image;
   * widths come from it. What the finder misses or invents is no part of the
   * error of drawn lines; how far raters differ is. In that place there are no
   * lines that were left out.
   */
  Rating rate_cracks(const cv::Mat            &grey,
                     const std::vector<Marks> &cracks,
                     const RatingSettings     &settings,
                     int                       n_octaves,
                     Segmentation             &segmentation);

  /** The same for exfoliations. */
  Rating rate_areas(const std::vector<Marks> &areas,
                    const RatingSettings     &settings,
                    Segmentation             &segmentation);

  /** Pairs of raters that agree on less than half of what they marked, by Dice,
   * a line for each: where as many raters are for a place as against it it
   * counts, so that a consensus of two such raters is the sum of their marks.
   */
  std::vector<std::string> disagreements(const Rating &rating);

  /** Adds how far raters differ to the errors of @p statistics. */
  void add_deviations(const std::optional<Rating> &cracks,
                      const std::optional<Rating> &areas,
                      ImageStatistics             &statistics);
} // namespace squeal::tribology

#endif
