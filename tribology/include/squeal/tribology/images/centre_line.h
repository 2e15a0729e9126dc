// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_images_centre_line_h
#define squeal_tribology_images_centre_line_h

#include <opencv2/core.hpp>

#include <vector>

namespace squeal::tribology
{
  using PixelPath = std::vector<cv::Point>;

  /** Skeleton of @p mask (CV_8U, 0 or 255) by Zhang and Suen's thinning,
   * without the corners of staircases, which would look like junctions. Of
   * diagonal lines of an even number of pixels it may leave nothing: for masks
   * that were drawn there is thin_marks(), the judge of found lines was
   * trained with this one. */
  cv::Mat thin(const cv::Mat &mask);

  /** The same with the change of Lue and Wang (1986): three neighbours at least
   * are needed to be taken away, so that diagonal lines of two pixels are not
   * eaten up from their ends. What is then left of two pixels goes one pixel
   * after the other. */
  cv::Mat thin_marks(const cv::Mat &mask);

  /** Removes branches of a skeleton of at most @p n pixels that end in a
   * junction, and thins again. */
  void remove_spurs(cv::Mat &skeleton, int n);

  /** The same, where @p half_widths (pixels, of the mask that the skeleton is
   * of) tell how wide it is: branches of at most one and a half times the half
   * width at their junction go as well. */
  void remove_spurs(cv::Mat &skeleton, int n, const cv::Mat1f &half_widths);

  /** Number of the eight neighbours that are set. */
  int n_neighbours(const cv::Mat &skeleton, const cv::Point &p);

  /** Moments of the pixels of a skeleton within @p reach of @p p in x and y. */
  cv::Moments moments_around(const cv::Mat   &skeleton,
                             const cv::Point &p,
                             int              reach);

  /** Direction of a skeleton at @p p, radians in [0, pi) from +x towards +y, from
   * its pixels within five; @p fallback where they are fewer than four. */
  double direction_at(const cv::Mat   &skeleton,
                      const cv::Point &p,
                      double           fallback);

  /** Pixels with one neighbour and the unit direction in which the line
   * would go on, from its last 12 pixels. */
  struct LineEnd
  {
    cv::Point   tip;
    cv::Point2d ahead;
    PixelPath   behind; /**< the last pixels, from the tip on */
  };
  std::vector<LineEnd> line_ends(const cv::Mat &skeleton);

  /** The pixel of a mask that is nearest to any pixel of the image. Throws
   * nothing; the mask must not be empty. */
  class NearestPixels
  {
  public:
    explicit NearestPixels(const cv::Mat &mask);

    /** Pixels; 0 on the mask. */
    double
    distance(const cv::Point &p) const
    {
      return distances(p);
    }

    const cv::Point &
    place(const cv::Point &p) const
    {
      return places[labels(p)];
    }

  private:
    cv::Mat1f distances;
    cv::Mat1i labels;
    PixelPath places;
  };

  /** A connected piece of a skeleton. */
  struct LinePiece
  {
    PixelPath pixels;
    PixelPath axis; /**< its longest shortest way, end to end */

    /** Distance of the two ends over the number of pixels between. */
    double chord_ratio() const;

    /** Root mean square distance of the axis from its best straight line,
     * pixels. */
    double waviness() const;
  };
  std::vector<LinePiece> line_pieces(const cv::Mat &skeleton);

  /** Steps to the eight neighbours; odd ones are diagonal. */
  extern const cv::Point neighbour_steps[8];
} // namespace squeal::tribology

#endif
