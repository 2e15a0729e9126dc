// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_images_crack_finder_h
#define squeal_tribology_images_crack_finder_h

#include <squeal/tribology/images/ridge_filter.h>

namespace squeal::tribology
{
  /** Cracks of one image. All of its size. */
  struct CrackMap
  {
    cv::Mat centre_line; /**< CV_8U, 255 on the skeleton */
    cv::Mat area;        /**< CV_8U, 255 on cracks */
    cv::Mat width;       /**< CV_32F, pixels, on the centre line */
    cv::Mat width_error; /**< CV_32F, deviation, pixels, on the centre line;
                            alike along a crack, apart between cracks */
    cv::Mat common_width_error; /**< as above, but alike in the image */
    cv::Mat direction; /**< CV_32F, radians in [0, pi), on the centre line */
    bool    is_drawn = false; /**< by people or other programs */
  };

  /** Centre lines and the evidence that they were found in. */
  struct CrackLines
  {
    RidgeField ridges;
    cv::Mat    centre_line;
  };

  /**
   * Centre lines of cracks.
   *
   * Crests of the evidence form a graph of edges between junctions. An edge
   * belongs to a crack by its mean contrast in units of noise, at its own
   * pixels and along the best path through them, and by how much darker it is
   * than both flanks; less is asked of short edges with high contrast and of
   * long wavy edges with a good path at half the resolution. Connected edges
   * are a crack when their strong ones add up to enough contrast over their
   * length. Edges on long straight lines are scratches, grooves or edges of the
   * specimen. From the ends of cracks the cheapest way over 70, then 35 pixels
   * ahead is added as long as its mean contrast exceeds what the same search
   * finds from crests of the background (median and three deviations) or it has
   * a good path at half the resolution, else the part of it that is contrasty
   * itself. At last the ends are moved to where the line stops being dark.
   *
   * Wide filters see faint cracks, narrow ones tell cracks apart from what lies
   * beside them and are fooled less often. The wider filters come first; when
   * the cracks that they start with keep 95 % of their strength (median over
   * their pixels) in filters of half an octave less, those are used.
   *
   * Nothing depends on quantiles of the evidence: an image without cracks
   * gives none. @p grey is CV_32F; for @p n_octaves see filter_ridges().
   */
  CrackLines find_cracks(const cv::Mat &grey, int n_octaves);

  /** Width, direction and area from the dark profile across the centre line:
   * the width is the missing light over the depth, see CrackDepth. @p grey is
   * CV_32F. */
  CrackMap measure_cracks(const cv::Mat    &grey,
                          const cv::Mat    &centre_line,
                          const RidgeField &ridges);
} // namespace squeal::tribology

#endif
