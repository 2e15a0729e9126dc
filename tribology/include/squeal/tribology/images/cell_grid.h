// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_images_cell_grid_h
#define squeal_tribology_images_cell_grid_h

#include <squeal/results/table.h>
#include <squeal/tribology/images/registration.h>
#include <squeal/tribology/images/segmentation.h>

#include <string>
#include <vector>

namespace squeal::tribology
{
  /** Features of the images gathered on cells of the pad or of one image. */
  class CellGrid
  {
  public:
    /** Cells over a rectangle of @p size (um) about the origin. */
    CellGrid(const cv::Size2d &size, int n_x, int n_y);

    /** Adds a segmented image whose pixels @p placement takes to um. Lengths,
     * widths and directions of cracks are those on the pad; @p sliding is the
     * direction there, radians from x towards y, the same of all images.
     * Cells of which an image @p is_synthetic say so. */
    void add(const Segmentation &segmentation,
             const Placement    &placement,
             double              sliding,
             bool                is_synthetic = false);

    /** Adds the mean of a covariate (CV_32F, size of the image) over what is
     * @p seen. */
    void add_covariate(const std::string &name,
                       const cv::Mat     &values,
                       const Placement   &placement,
                       const SeenPixels  &seen = {});

    /** What the images show of the cells, parts that several of them show
     * counted once. */
    struct SeenOnce
    {
      double area         = 0.; /**< um^2 */
      double crack_length = 0.; /**< um, of each cell its mean density */
      double share        = 1.; /**< area over the sum of the images' areas */
    };
    SeenOnce seen_once() const;

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
    void note_view(const cv::Size   &size_of_image,
                   const SeenPixels &seen,
                   const Placement  &placement);
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
    double                 sliding      = 0.;
    bool                   is_synthetic = false;
  };
} // namespace squeal::tribology

#endif
