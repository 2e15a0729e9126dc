// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_images_statistics_h
#define squeal_tribology_images_statistics_h

#include <squeal/results/table.h>
#include <squeal/tribology/images/registration.h>
#include <squeal/tribology/images/segmentation.h>

#include <optional>
#include <string>
#include <vector>

namespace squeal::tribology
{
  /** Figures of one image; angles against the sliding direction. */
  struct ImageStatistics
  {
    static constexpr int n_orientations = 12;

    double observed_area = 0.; /**< mm^2 */
    int    n_cracks      = 0;  /**< connected */
    double crack_length  = 0.; /**< mm */
    double crack_density = 0.; /**< mm per mm^2 */
    double crack_area    = 0.; /**< mm^2 */
    double crack_width   = 0.; /**< um, mean along the length */
    /** Deviations: length by its pixels, its ends and what is usually missed
     * or invented; width by the depth of cracks; area by both. */
    double              crack_length_error = 0.; /**< mm */
    double              crack_area_error   = 0.; /**< mm^2 */
    double              crack_width_error  = 0.; /**< um */
    std::vector<double> orientation; /**< length share in bins of 15 degrees
                                        from 0 (along the sliding direction) */
    double exfoliation_fraction = 0.;
    /** Deviations: outlines, dark places without a rim, how far raters differ;
     * that of the plateaus is no less than their share, as nothing but their
     * brightness speaks for them. */
    double exfoliation_fraction_error = 0., plateau_fraction_error = 0.;
    /** Dark places without a rim: shading, stains or exfoliations. */
    double              unsettled_fraction = 0.;
    std::vector<double> exfoliation_areas; /**< um^2, largest first */
    double              plateau_fraction = 0.;
    std::vector<double> plateau_areas; /**< um^2, largest first */

    /** Whether the area of exfoliations is more than two deviations, so that
     * there are some. */
    bool
    shows_exfoliations() const
    {
      return exfoliation_fraction > 2. * exfoliation_fraction_error;
    }
  };

  /** The sliding direction as an image shows it. */
  struct SlidingInImage
  {
    double direction   = 0.;    /**< radians from x towards y */
    bool   is_mirrored = false; /**< angles on the pad go the other way round */
  };

  /** The direction @p on_pad, radians from the x axis of the pad towards its y
   * axis, in an image that @p placement takes to the pad, at @p middle. */
  SlidingInImage sliding_in_image(double             on_pad,
                                  const Placement   &placement,
                                  const cv::Point2d &middle);

  ImageStatistics measure(const Segmentation   &segmentation,
                          double                pixel_size,
                          const SlidingInImage &sliding);

  /** Features of the images gathered on cells of the pad or of one image. */
  class CellGrid
  {
  public:
    /** Cells over a rectangle of @p size (um) about the origin. */
    CellGrid(const cv::Size2d &size, int n_x, int n_y);

    /** Adds a segmented image whose pixels @p placement takes to um. Lengths,
     * widths and directions of cracks are those on the pad; @p sliding is the
     * direction there, radians from x towards y. */
    void add(const Segmentation &segmentation,
             const Placement    &placement,
             double              sliding);

    /** Adds the mean of a covariate (CV_32F, size of the image). */
    void add_covariate(const std::string &name,
                       const cv::Mat     &values,
                       const Placement   &placement);

    /** Columns of the table; covariates come last. */
    std::vector<Table::Column> columns() const;

    /** One row for each cell, after the name of the image. */
    void append_rows(Table &table, const std::string &image) const;

  private:
    struct Cell
    {
      double area = 0., crack_length = 0., crack_width = 0., cosine = 0.,
             sine = 0., exfoliation = 0., plateau = 0.; // um
    };
    struct Covariate
    {
      std::string         name;
      std::vector<double> sum, weight;
    };
    int index(const cv::Point2d &p) const;
    /** Notes which parts of the cells an image shows. */
    void note_view(const cv::Size &size_of_image, const Placement &placement);
    /** What images show of a cell over what they show of it one by one: less
     * than 1 where they overlap. */
    double share_seen_once(int i, int j) const;

    /** Overlaps are seen on a grid of so many parts in each direction. */
    static constexpr int parts_of_a_cell = 32;

    cv::Size2d             size;
    int                    n_x, n_y;
    std::vector<Cell>      cells;
    std::vector<Covariate> covariates;
    cv::Mat1f              views; /**< number of images that show each part */
  };

  /** The picture with cracks in red, exfoliations outlined in magenta, dark
   * places without a rim in grey and plateaus in blue (CV_8UC3). */
  cv::Mat draw_overlay(const cv::Mat &grey, const Segmentation &segmentation);
} // namespace squeal::tribology

#endif
