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
  /** Features of the images gathered on cells of the pad or of one image. What
   * several images show is taken from the first of them alone. */
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

    /** Adds the mean of a covariate (CV_32F, size of the image) over the area
     * on the pad of what is @p seen. */
    void add_covariate(const std::string &name,
                       const cv::Mat     &values,
                       const Placement   &placement,
                       const SeenPixels  &seen = {});

    /** What the images show of the cells, parts that several of them show
     * counted once. */
    struct SeenOnce
    {
      double area         = 0.; /**< um^2 */
      double crack_length = 0.; /**< um */
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
    /** What an image shows of the pad. */
    struct View
    {
      View(const cv::Size   &size,
           const SeenPixels &seen,
           const Placement  &placement);

      bool may_show_of(const View &other) const;
      bool shows(const cv::Point2d &place) const;

      Placement   to_pixel; /**< of the pad, um */
      cv::Size    size;
      SeenPixels  seen;
      cv::Point2d low, high; /**< of the box around it, um */
    };
    int index(const cv::Point2d &p) const;
    /** Adds the crack of pixel @p at, on whose line it has @p pixel_length
     * pixels. */
    void add_crack(Cell             &cell,
                   const PixelOnPad &pixel,
                   const CrackMap   &cracks,
                   const cv::Point  &at,
                   double            pixel_length) const;

    cv::Size2d             size;
    int                    n_x, n_y;
    std::vector<Cell>      cells;
    std::vector<Covariate> covariates;
    std::vector<View>      views;
    double                 area_of_images = 0.; /**< um^2, on the pad */
    double                 sliding        = 0.;
    bool                   is_synthetic   = false;
  };
} // namespace squeal::tribology

#endif
