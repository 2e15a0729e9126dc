// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_results_shape_plot_h
#define squeal_results_shape_plot_h

#include <squeal/results/plotter.h>
#include <squeal/results/shape_view.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace squeal
{
  /** A mode shape to be drawn without a display. */
  struct ShapePicture
  {
    std::string            title;
    std::string            subtitle;
    std::vector<ShapeQuad> surface; /**< deformed, all bodies */
    std::vector<ShapeQuad> face;    /**< undeformed contact face of the disc */
    std::vector<ShapeQuad> contact; /**< what stands on it, for its outline */
    std::string value_label = "axial displacement / largest of the face";
    Viewpoint   viewpoint;
    bool        face_looks_down = false; /**< it is seen through the disc */
  };

  /**
   * Draws two panels: the deformed scene, lit and seen obliquely, and the
   * disc's contact face seen from +z with the nodal lines in black and the
   * outline of the contact dashed. Both are coloured by the values over the
   * largest of the face (of the surface if there is no face), blue to red.
   * Without face quads the first panel is alone. Writes
   * @p path.png and returns whether it is there.
   */
  bool plot_shape(const Plotter      &plotter,
                  const ShapePicture &picture,
                  const std::string  &path);

  /**
   * Makes the quads of a picture from quads that know their undeformed corners
   * (`corners[i][d]`, m), `displacements[i][d]` and `body`. The largest drawn
   * displacement is @p drawn_largest (m); the values are the displacements
   * along z. The face is what lies on top (largest z) of the body
   * @p disc_body, or at its bottom if its contact face @p looks_down; the
   * contact is what other bodies have in that plane.
   */
  template <typename Quad>
  ShapePicture make_shape_picture(const std::vector<Quad> &quads,
                                  const unsigned int       disc_body,
                                  const double             drawn_largest,
                                  const bool               looks_down = false);



  template <typename Quad>
  ShapePicture
  make_shape_picture(const std::vector<Quad> &quads,
                     const unsigned int       disc_body,
                     const double             drawn_largest,
                     const bool               looks_down)
  {
    double largest = 0., top = -1e300, bottom = 1e300;
    for (const Quad &quad : quads)
      for (unsigned int i = 0; i < 4; ++i)
        {
          const auto &u = quad.displacements[i];
          largest       = std::max(
            largest, std::sqrt(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]));
          if (quad.body != disc_body)
            continue;
          top    = std::max(top, double(quad.corners[i][2]));
          bottom = std::min(bottom, double(quad.corners[i][2]));
        }
    const double scale  = largest > 0. ? drawn_largest / largest : 0.;
    const double height = looks_down ? bottom : top;

    ShapePicture picture;
    picture.face_looks_down = looks_down;
    if (looks_down)
      picture.viewpoint.elevation *= -1.;
    for (const Quad &quad : quads)
      {
        ShapeQuad flat, deformed;
        bool      on_face = true;
        for (unsigned int i = 0; i < 4; ++i)
          {
            for (unsigned int d = 0; d < 3; ++d)
              {
                flat.corners[i][d] = quad.corners[i][d];
                deformed.corners[i][d] =
                  quad.corners[i][d] + scale * quad.displacements[i][d];
              }
            flat.values[i] = deformed.values[i] = quad.displacements[i][2];
            on_face = on_face && std::abs(height - quad.corners[i][2]) <=
                                   1e-6 * (top - bottom);
          }
        picture.surface.push_back(deformed);
        if (on_face && quad.body == disc_body)
          picture.face.push_back(flat);
        else if (on_face)
          picture.contact.push_back(flat);
      }
    return picture;
  }
} // namespace squeal

#endif
