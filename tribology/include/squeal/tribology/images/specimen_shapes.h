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
} // namespace squeal::tribology

#endif
