// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_images_specimen_shapes_h
#define squeal_tribology_images_specimen_shapes_h

#include <squeal/tribology/images/specimen.h>

#include <vector>

namespace squeal::tribology
{
  using Curve = std::vector<cv::Point2d>; /**< um */

  /** A crack or a branch: centre line with width and depth at each point. */
  struct CrackShape
  {
    Curve               line;
    std::vector<double> width; /**< um */
    std::vector<double> depth; /**< share of the brightness that is lost */
    bool                is_branch = false;
  };

  /** A straight thin feature. */
  struct Rod
  {
    cv::Point2d begin, end;
    double      width = 1.; /**< um */
    double      tone  = 0.; /**< added brightness */
  };

  /** Everything that is drawn, in um. */
  struct SpecimenShapes
  {
    std::vector<Curve>      exfoliations, plateaus;
    std::vector<CrackShape> cracks;
    std::vector<Rod>        fibres, grooves;
  };

  /** Draws the shapes of a specimen from its seed. */
  SpecimenShapes draw_shapes(const SpecimenSettings &settings);

  /** Length of the centre lines inside the field of @p view, um. Where a centre
   * line runs inside a crack drawn before, as a branch does before it leaves
   * its parent, there is one dark line and it counts once. Lines are sampled in
   * twelfths of their steps. */
  double seen_crack_length(const std::vector<CrackShape> &cracks,
                           const cv::Size2d              &view);
} // namespace squeal::tribology

#endif
