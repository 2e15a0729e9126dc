// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_images_crack_finder_h
#define squeal_tribology_images_crack_finder_h

#include <squeal/tribology/images/crack_depth.h>
#include <squeal/tribology/images/line_objection.h>

namespace squeal::tribology
{
  /** A dark line that was looked at and left out. */
  struct ExcludedLine
  {
    PixelPath pixels;
    double    probability = 0.; /**< of being a crack all the same */
    Exclusion reason      = Exclusion::faint;
    double    width       = 0.; /**< pixels, of a band; else 0 */
  };

  /** What a finder expects to be wrong in its own result, pixels of length. */
  struct FinderDoubt
  {
    double missed = 0., invented = 0.;
    double unsettled = 0.; /**< deviation from 0 of what may be cracks with
                              even odds: lines where no crack is found, and
                              dark bands */
    double ends = 0.;     /**< deviation by where in a filled outline lines that
                             people drew end */
    bool is_drawn = true; /**< by people: nothing is too short for them */
  };

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
    FinderDoubt doubt; /**< nothing but ends where people drew the lines */
    /** Pixels of the centre line along which the picture shows no dark line,
     * so that their width is not known: its deviation is the largest width. */
    double without_line = 0.;
    /** By the shapes of the cracks. */
    OpticalBlur blur;
    /** Pixels of gaps: six and more of a line in a row that are less than a
     * third as dark as the line on both sides. */
    double bridged = 0.;
  };

  /** Centre lines and the evidence that they were found in. */
  struct CrackLines
  {
    RidgeField                ridges;
    cv::Mat                   centre_line;
    std::vector<ExcludedLine> excluded;
    FinderDoubt               doubt;
  };

  /**
   * Centre lines of cracks.
   *
   * Crests of the evidence form a graph of lines between junctions. Each is
   * judged by what a crack looks like, alone and among the lines that it goes
   * on in: LineJudge. Connected lines are a crack when their log odds add up to
   * enough over their length. From the ends of cracks the cheapest way over 70,
   * then 35 pixels ahead is added as long as its mean contrast exceeds what the
   * same search finds from crests of the background (median and three
   * deviations) or it has a good path at half the resolution, else the part of
   * it that is contrasty itself. At last the ends are moved to where the line
   * stops being dark.
   *
   * Filters are narrow. Where wide ones see the cracks stronger and bring half
   * as much evidence again, as on coarse grains, they are used instead.
   *
   * Nothing depends on quantiles of the evidence: an image without cracks
   * gives none. @p grey is CV_32F; for @p n_octaves see filter_ridges(). No
   * crack lies or leads where nothing is @p seen.
   */
  CrackLines find_cracks(const cv::Mat    &grey,
                         int               n_octaves,
                         const LineJudge  &judge = LineJudge::standard(),
                         const SeenPixels &seen  = {});

  /** The widest line that filters of @p n_octaves reach, pixels. */
  double width_of_octaves(int n_octaves);

  /** Width, direction and area from the dark profile across the centre line:
   * the width is the missing light over the depth, see CrackDepth and
   * dips_along(). @p grey is CV_32F. Dark bands wider than @p largest_width
   * (pixels) are not told from a dark surface. */
  CrackMap measure_cracks(const cv::Mat    &grey,
                          const cv::Mat    &centre_line,
                          const RidgeField &ridges,
                          double            largest_width = 9.);
} // namespace squeal::tribology

#endif
