// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_results_shape_picture_h
#define squeal_results_shape_picture_h

#include <squeal/results/shape_view.h>
#include <squeal/results/surface_quads.h>

#include <array>
#include <string>
#include <vector>

namespace squeal
{
  /** A body of a picture. */
  struct PicturedBody
  {
    std::string name;
    /** How many times as far as the one that moves most it is drawn; 1 unless
     * it would hardly be seen to move. */
    double times = 1.;
    /** Its highest point on the canvas, as drawn, m. */
    std::array<double, 3> top = {{0., 0., 0.}};
  };

  /** A straight piece of line in space, m. */
  using SpaceLine = std::array<std::array<double, 3>, 2>;

  /** A mode shape to be drawn without a display. */
  struct ShapePicture
  {
    std::string               title;
    std::string               subtitle;
    std::vector<ShapeQuad>    surface;            /**< deformed, all bodies */
    std::vector<SpaceLine>    undeformed;         /**< its edges at rest */
    std::vector<PicturedBody> bodies;             /**< by their numbers */
    double                    drawn_largest = 0.; /**< displacement, m */
    std::vector<ShapeQuad>    face; /**< undeformed contact face of the disc */
    std::vector<ShapeQuad> contact; /**< what stands on it, for its outline */
    std::string value_label = "axial displacement / largest of the face";
    Viewpoint   viewpoint;
    bool        face_looks_down = false; /**< it is seen through the disc */
    /** What the three directions of the places are called: of a disc that was
     * laid flat those of the scene that it had there. */
    std::array<std::string, 3> directions{{"x", "y", "z"}};
  };

  /**
   * The picture of surfaces that move. The largest drawn displacement is
   * @p drawn_largest (m); a body whose own largest is below a fifth of that of
   * all is drawn 2, 5, 10, 20 ... times as far, the most that stays below.
   * Values are the displacements along z. The face is what lies
   * in the highest plane across z in which others touch the body @p disc_body,
   * or the lowest if its contact face @p looks_down; without any, on top of it
   * or at its bottom. The contact is what other bodies have in that plane.
   * @p names: of the bodies; none: bodies have no labels.
   */
  ShapePicture make_shape_picture(const std::vector<SurfaceQuad> &quads,
                                  const unsigned int              disc_body,
                                  const double                    drawn_largest,
                                  const bool looks_down                 = false,
                                  const std::vector<std::string> &names = {});

  /** Where @p quads of one body meet at more than @p degrees, or end. */
  std::vector<SpaceLine> feature_edges(const std::vector<SurfaceQuad> &quads,
                                       const double                    degrees);
} // namespace squeal

#endif
