// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_images_crack_growth_h
#define squeal_tribology_images_crack_growth_h

#include <squeal/tribology/images/centre_line.h>
#include <squeal/tribology/images/ridge_filter.h>

namespace squeal::tribology
{
  /** Extends the ends of a skeleton along crests that are stronger than the
   * same search finds in the background, or that lie on a good path at half the
   * resolution; see find_cracks(). A longer
   * search finds fainter cracks, because chance averages out along it; a
   * shorter one finds short rests. */
  class CrackGrowth
  {
  public:
    /** @p contrast is that of @p ridges at each pixel, without what must not
     * lead on. The background is what lies away from @p centre_line; of its
     * spread only the lower half counts, since cracks that have not been found
     * yet make the upper one. @p darkness: by how much each pixel is darker than
     * the darker flank, relative to it; a crack does not lose most of it at
     * once. @p reach: pixels that are searched ahead. */
    CrackGrowth(const RidgeField &ridges,
                const cv::Mat    &contrast,
                const cv::Mat1f  &darkness,
                const cv::Mat    &centre_line,
                double            reach);

    /** Mean strength that an extension needs. */
    double
    needed_strength() const
    {
      return threshold;
    }

    /** The skeleton with its extensions, thinned. */
    cv::Mat grow(const cv::Mat &centre_line) const;

    /** The skeleton with the contrasty beginnings of extensions that are too
     * weak as a whole, thinned. */
    cv::Mat finish_ends(const cv::Mat &centre_line) const;

    /** The skeleton with its ends where the darkness along the line falls
     * below a third of that farther back: the place up to which its sum over
     * that level is largest, between 6 pixels back and 4 ahead. This is the
     * most likely place of a step in normal noise; filters that average along
     * a line end too early or too late, by contrast. Ends within 6 pixels of
     * the border of the image are not moved back. */
    cv::Mat place_ends(const cv::Mat &centre_line) const;

  private:
    struct Extension
    {
      PixelPath way; /**< empty: nothing ahead */
      double    mean_strength = -1., mean_coarse = -1.;
      bool      is_full = false; /**< went the whole way */
    };
    Extension extend(const LineEnd &end, const cv::Mat &network) const;
    void      calibrate(const cv::Mat &centre_line);
    double    mean_darkness(const PixelPath &pixels) const;

    const RidgeField &ridges;
    const cv::Mat     contrast;
    const cv::Mat1f   darkness;
    const double      reach;
    cv::Mat           cost;
    double            threshold = 0.;
  };
} // namespace squeal::tribology

#endif
