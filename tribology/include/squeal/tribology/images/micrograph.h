// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_images_micrograph_h
#define squeal_tribology_images_micrograph_h

#include <squeal/tribology/images/image_size.h>
#include <squeal/tribology/images/seen_pixels.h>

#include <opencv2/core.hpp>

#include <optional>
#include <string>
#include <vector>

namespace squeal::tribology
{
  /** What a microscope writes beside the pixels. */
  struct ImageMetadata
  {
    std::optional<double>   pixel_size; /**< um, root of the area */
    std::optional<cv::Size> size; /**< px, of the picture with these pixels */
    std::optional<cv::Point2d> stage;  /**< um, of the image centre */
    std::string                source; /**< "FEI tags", ... or empty */
    std::string without_scale; /**< why an entry for it tells none, or empty */
    bool        is_synthetic = false;
    double      aspect       = 1.; /**< height of a pixel over its
                                      width */
    /** Degrees by which the stage and the scan were turned, as their makers
     * count them; 0 where the file says nothing. */
    double stage_rotation = 0., scan_rotation = 0.;
  };

  /** Box around a scale bar and the length that it stands for. */
  struct ScaleBar
  {
    cv::Rect box;         /**< pixels; empty: none */
    double   length = 0.; /**< um */
  };

  /** One grey image with its scale. */
  struct Micrograph
  {
    std::string path;
    std::string stem;
    cv::Mat     grey;      /**< CV_32F, 0 to 255 whatever the depth was */
    SeenPixels  seen;      /**< of the size of grey */
    cv::Rect    frame;     /**< the specimen, without data bar */
    cv::Rect    scale_bar; /**< with its label, where it told the scale; may
                              be empty or in the data bar */
    double        pixel_size = 0.; /**< um */
    std::string   scale_source;
    ImageMetadata metadata;
    int           orientation = 1; /**< tag of the file; grey is upright */
    int           bits        = 0; /**< taken for black to white of a file of 16
                                      bit, 0 of one of 8 */
    /** What was made of the file, and what is wrong with it, for the log. */
    std::vector<std::string> notes, warnings;
  };

  /**
   * Metadata of an image file: FEI or Zeiss tags of a TIFF, text chunks that a
   * synthetic specimen has, or the text file of the same stem that JEOL
   * microscopes write. Nothing there leaves it empty.
   */
  ImageMetadata read_metadata(const std::string &path);

  /** Columns and rows: "640 x 480". */
  std::string size_text(const cv::Size &size);

  /** Grey values of a file, see read_pixels(), scaled to 0..255, CV_32F. Of 16
   * bit the bits that the picture uses are the range: a camera of 12 bits has
   * its white at 4095. */
  cv::Mat read_grey(const std::string &path,
                    double             largest = usual_largest_image);

  /** The brightness that @p share of the pixels of a CV_32F image do not
   * exceed. */
  float quantile_of(const cv::Mat &grey, double share);

  /** Rows above a data bar at the bottom; all rows when there is none. A data
   * bar is at least 2 and at most 20 percent of the height and has one and the
   * same value in more than half of each row, but for lines across it, and in
   * 70 percent of its pixels; it ends from one row to the next. */
  int rows_above_data_bar(const cv::Mat &grey);

  /** Pixels of the longest horizontal run in the box that differs from the
   * background at the border of the box: a bright bar on dark or a dark one on
   * bright. Of a bar in two halves with its label between them it is the
   * length from end to end. Throws InputError when there is no bar, when there
   * are several beside one another, or when it reaches the left or the right
   * border, where nobody can tell how long it is. */
  double scale_bar_pixels(const cv::Mat     &grey,
                          const cv::Rect    &box,
                          const std::string &path);

  /** The pixels of a scale bar that are no picture: @p box, the label of one
   * value in which it lies, text of the bar's brightness at most 40 pixels
   * above and below, and 3 pixels around all of them. There must be a bar in
   * the box, see scale_bar_pixels(). */
  cv::Rect scale_bar_place(const cv::Mat &grey, const cv::Rect &box);

  /**
   * Reads an image with its scale: @p pixel_size (um) if it is not 0, else the
   * scale bar if one is given, else the metadata. Where these state another
   * size in pixels, the image is a copy of that size if its rows say so, with a
   * warning, and has no scale if they do not; where they state none, a note
   * says
   * so. @p data_bar: rows at the
   * bottom that are no picture, -1 for rows_above_data_bar(). @p least_bits:
   * files of 16 bit have the range of so many at least, so that images of one
   * exposure keep one brightness. Throws InputError when there is no scale or
   * nothing above the data bar.
   */
  Micrograph read_micrograph(const std::string &path,
                             double             pixel_size,
                             const ScaleBar    &bar      = {},
                             double             largest  = usual_largest_image,
                             int                data_bar = -1,
                             int                least_bits = 8);
} // namespace squeal::tribology

#endif
