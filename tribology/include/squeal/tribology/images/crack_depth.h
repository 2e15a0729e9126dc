// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_images_crack_depth_h
#define squeal_tribology_images_crack_depth_h

#include <Eigen/Core>

#include <vector>

namespace squeal::tribology
{
  /** The dark profile across a line, relative to the brightness beside it. */
  struct Dip
  {
    double deficit = 0.; /**< missing light, pixels: width times depth */
    double peak    = 0.; /**< in its middle */
  };

  /** By how much optics blur an image: a Gaussian. */
  struct OpticalBlur
  {
    double value       = 0.7;   /**< deviation, pixels; a lens in focus */
    double error       = 0.;    /**< of that, relative, where it is measured */
    bool   is_measured = false; /**< else it is assumed, within 20 % of the
                                     whole blur of a profile */
  };

  /**
   * Splits the missing light of a crack into its width and its depth, the share
   * of the brightness that the open crack lacks.
   *
   * The profile is a box of width w and depth d, blurred by a Gaussian of
   * deviation b: deficit w d, peak d erf(w / (2 sqrt(2) b)). A wide crack
   * shows d, of a narrow one the deficit is all that is seen. Its depth is then
   * that of the other cracks of the image, and where none is wide enough an
   * assumed one, which may not hold: the less of a crack is seen, the more its
   * error says so. The probability of each depth is the product of what the
   * peak, the image and the assumption say of it. Of the blur cracks tell only
   * which one no depth fits: as narrower shallower cracks fit a sharper image
   * as well, how many depths do is no evidence, and of many cracks that are
   * alike it would make one blur sure.
   */
  class CrackDepth
  {
  public:
    /** One list of dips for each connected crack. @p bends is the variance
     * of a crack about a straight line along which its profiles were averaged,
     * pixels^2; it adds to the blur, as does that of the @p optics. */
    CrackDepth(const std::vector<std::vector<Dip>> &cracks,
               double                               bends,
               const OpticalBlur                   &optics = {});

    struct Width
    {
      double value  = 0.; /**< pixels, of the median depth */
      double own    = 0.; /**< deviation, pixels, alike along a crack */
      double common = 0.; /**< deviation, pixels, alike in the image */
    };

    /** Deviations are about the value. The deficit must be positive. */
    Width width(const Dip &dip) const;

  private:
    /** Of a crack with the missing light of @p dip: depths in rows, blurs in
     * columns. */
    Eigen::ArrayXXd peaks(const Dip &dip) const;

    double          blur;       // pixels, the likeliest
    double          blur_error; // of that, relative
    Eigen::ArrayXd  depths;     // logarithms
    Eigen::MatrixXd scatter; // of cracks (columns) in images of a mean (rows)
    // Probabilities, blurs in columns: of means of the image, and of depths of
    // a crack in it before its peak is looked at.
    Eigen::ArrayXXd means, before;
    // Those of depths by which a width is stated: with the likeliest blur, an
    // error of which changes it more to one side, and with the assumption if
    // that is likelier to hold than not.
    Eigen::ArrayXd likely;
  };
} // namespace squeal::tribology

#endif
