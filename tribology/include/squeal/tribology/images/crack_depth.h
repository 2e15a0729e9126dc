// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_images_crack_depth_h
#define squeal_tribology_images_crack_depth_h

#include <vector>

namespace squeal::tribology
{
  /** The dark profile across a line, relative to the brightness beside it. */
  struct Dip
  {
    double deficit = 0.; /**< missing light, pixels: width times depth */
    double peak    = 0.; /**< in its middle */
  };

  /**
   * Splits the missing light of a crack into its width and its depth, the share
   * of the brightness that the open crack lacks.
   *
   * The profile is a box of width w and depth d, blurred by a Gaussian of
   * deviation b: deficit w d, peak d erf(w / (2 sqrt(2) b)). A wide crack
   * shows d, of a narrow one the deficit is all that is seen. Its depth is then
   * that of the other cracks of the image, and where none is wide enough an
   * assumed one. All three are weighed by their errors.
   */
  class CrackDepth
  {
  public:
    /** One list of dips for each connected crack. @p bends is the variance
     * of a crack about a straight line along which its profiles were averaged,
     * pixels^2; it adds to the blur. */
    CrackDepth(const std::vector<std::vector<Dip>> &cracks, double bends);

    struct Width
    {
      double value  = 0.; /**< pixels */
      double own    = 0.; /**< deviation, pixels, alike along a crack */
      double common = 0.; /**< deviation, pixels, alike in the image */
    };

    Width width(const Dip &dip) const;

    /** Mean depth of the cracks of the image. */
    double
    mean() const
    {
      return mean_depth;
    }

    /** Its deviation. */
    double
    mean_error() const
    {
      return error;
    }

  private:
    double blur, mean_depth, error;
  };
} // namespace squeal::tribology

#endif
