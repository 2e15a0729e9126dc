// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_images_crack_growth_h
#define squeal_tribology_images_crack_growth_h

#include <squeal/tribology/images/centre_line.h>
#include <squeal/tribology/images/ridge_filter.h>

namespace squeal::tribology
{
  /** Extends the ends of a skeleton along crests that are stronger than the
   * same search finds in the background; see find_centre_lines(). */
  class CrackGrowth
  {
  public:
    /** @p contrast is that of @p ridges at each pixel, without what must not
     * lead on. The background is what lies away from @p centre_line. */
    CrackGrowth(const RidgeField &ridges,
                const cv::Mat    &contrast,
                const cv::Mat    &centre_line);

    /** Mean strength that an extension needs. */
    double
    needed_strength() const
    {
      return threshold;
    }

    /** The skeleton with its extensions, thinned. */
    cv::Mat grow(const cv::Mat &centre_line) const;

  private:
    struct Extension
    {
      PixelPath way; /**< empty: nothing ahead */
      double    mean_strength = -1.;
      bool      is_full       = false; /**< went the whole way */
    };
    Extension extend(const LineEnd &end, const cv::Mat &network) const;
    void      calibrate(const cv::Mat &centre_line);
    void      finish_ends(cv::Mat &network) const;

    const RidgeField &ridges;
    const cv::Mat     contrast;
    cv::Mat           cost;
    double            threshold = 0.;
  };
} // namespace squeal::tribology

#endif
