// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_results_shape_view_h
#define squeal_results_shape_view_h

#include <array>
#include <cstddef>
#include <vector>

namespace squeal
{
  /** A piece of surface as it is drawn: four corners counter-clockwise seen
   * from outside the body, m, and the value that colours each. */
  struct ShapeQuad
  {
    std::array<std::array<double, 3>, 4> corners;
    std::array<double, 4>                values;
  };

  /** Where the eye is: parallel light rays towards the viewer, seen from
   * @p azimuth (0 is +x, 90 is +y) at @p elevation above the x-y plane. */
  struct Viewpoint
  {
    double azimuth   = 40.; /**< degrees */
    double elevation = 28.;
  };

  /** A quad on the canvas: corners in the units of the scene along the canvas,
   * and a colour 0xRRGGBB. */
  struct CanvasQuad
  {
    std::array<std::array<double, 2>, 4> corners;
    unsigned int                         colour = 0;
    /** Whether the side from corner i to i + 1 is one of the quad it was cut
     * from. */
    std::array<bool, 4> has_edge = {{false, false, false, false}};
  };

  /** A straight piece of line on the canvas. */
  using CanvasLine = std::array<std::array<double, 2>, 2>;

  /** Blue (-1) over near-white (0) to red (+1), darker towards both ends, by a
   * scale whose ends differ for every kind of colour vision; values beyond are
   * moved to the end. */
  unsigned int diverging_colour(double value);

  /** Largest |value| of all corners. */
  double largest_value(const std::vector<ShapeQuad> &quads);

  /** Place of a point of space on the canvas (right, up) and its depth, which
   * grows towards the eye. */
  std::array<double, 3> project(const std::array<double, 3> &point,
                                const Viewpoint             &viewpoint);

  /**
   * @p quads seen from @p viewpoint, farthest first, so that drawing them in
   * order hides what is hidden; those that look away are left out. They are cut
   * into about @p n_pieces pieces of like size, whose colour is the value over
   * @p range, shaded by their inclination.
   */
  std::vector<CanvasQuad> view_from(const std::vector<ShapeQuad> &quads,
                                    const Viewpoint              &viewpoint,
                                    double                        range,
                                    std::size_t                   n_pieces);

  /** @p quads seen straight from +z, x to the right, without shading. */
  std::vector<CanvasQuad> view_from_above(const std::vector<ShapeQuad> &quads,
                                          double                        range,
                                          std::size_t n_pieces);

  /** Where the value is zero, seen from +z: the nodal lines. */
  std::vector<CanvasLine> zero_lines(const std::vector<ShapeQuad> &quads);

  /** Points of the canvas that are joined by lines. */
  using CanvasPath = std::vector<std::array<double, 2>>;

  /** Edges that belong to one quad only, seen from +z and joined end to end:
   * the outline of a face. Corners nearer than 1e-9 m are the same. */
  std::vector<CanvasPath> outline(const std::vector<ShapeQuad> &quads);
} // namespace squeal

#endif
