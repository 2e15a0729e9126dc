// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/results/shape_picture.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace squeal
{
  namespace
  {
    using Place = std::array<double, 3>;

    double
    length(const Place &u)
    {
      return std::sqrt(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
    }

    Place
    normal_of(const SurfaceQuad &quad)
    {
      const auto &c = quad.corners;
      Place       a, b;
      for (unsigned int d = 0; d < 3; ++d)
        {
          a[d] = c[2][d] - c[0][d];
          b[d] = c[3][d] - c[1][d];
        }
      Place        n    = {{a[1] * b[2] - a[2] * b[1],
                            a[2] * b[0] - a[0] * b[2],
                            a[0] * b[1] - a[1] * b[0]}};
      const double size = length(n);
      for (double &component : n)
        component /= size > 0. ? size : 1.;
      return n;
    }

    /** The largest of 1, 2, 5, 10, 20 ... that is at most @p bound. */
    double
    round_number_below(const double bound)
    {
      double result = 1.;
      for (double power = 1.; power <= bound; power *= 10.)
        for (const double digit : {1., 2., 5.})
          if (digit * power <= bound)
            result = digit * power;
      return result;
    }

    /** Below this share of the largest motion a body gets a scale of its own,
     * and below the other it counts as at rest. */
    constexpr double dwarfed = 0.2, at_rest = 1e-4;

    std::vector<PicturedBody>
    bodies_of(const std::vector<SurfaceQuad> &quads,
              const std::vector<std::string> &names)
    {
      std::vector<double> largest(names.size(), 0.);
      double              of_all = 0.;
      for (const SurfaceQuad &quad : quads)
        for (const Place &u : quad.displacements)
          {
            if (quad.body >= largest.size())
              largest.resize(quad.body + 1, 0.);
            largest[quad.body] = std::max(largest[quad.body], length(u));
            of_all             = std::max(of_all, length(u));
          }
      std::vector<PicturedBody> bodies(largest.size());
      for (std::size_t b = 0; b < bodies.size(); ++b)
        {
          if (b < names.size())
            bodies[b].name = names[b];
          if (largest[b] < dwarfed * of_all && largest[b] > at_rest * of_all)
            bodies[b].times = round_number_below(of_all / largest[b]);
        }
      return bodies;
    }
    /** Whether the quad lies in a plane across z: at the height of its first
     * corner, to @p tolerance. */
    bool
    is_level(const SurfaceQuad &quad, const double tolerance)
    {
      return std::all_of(
        quad.corners.begin(), quad.corners.end(), [&](const Place &x) {
          return std::abs(x[2] - quad.corners[0][2]) <= tolerance;
        });
    }

    /** Height of the disc's face that others touch, the one farthest up, or
     * down where it @p looks_down; the end of the disc where none does. A hat
     * or a flange may stand beyond it. */
    double
    height_of_face(const std::vector<SurfaceQuad> &quads,
                   const unsigned int              disc_body,
                   const bool                      looks_down,
                   const double                    tolerance)
    {
      std::vector<double> others;
      for (const SurfaceQuad &quad : quads)
        if (quad.body != disc_body && is_level(quad, tolerance))
          others.push_back(quad.corners[0][2]);
      std::sort(others.begin(), others.end());
      const double sign = looks_down ? -1. : 1.;
      double       end = -std::numeric_limits<double>::max(), touched = end;
      for (const SurfaceQuad &quad : quads)
        if (quad.body == disc_body)
          {
            for (const Place &x : quad.corners)
              end = std::max(end, sign * x[2]);
            const double z = quad.corners[0][2];
            const auto   near =
              std::lower_bound(others.begin(), others.end(), z - tolerance);
            if (is_level(quad, tolerance) && near != others.end() &&
                *near <= z + tolerance)
              touched = std::max(touched, sign * z);
          }
      return sign *
             (touched > -std::numeric_limits<double>::max() ? touched : end);
    }
  } // namespace



  ShapePicture
  make_shape_picture(const std::vector<SurfaceQuad> &quads,
                     const unsigned int              disc_body,
                     const double                    drawn_largest,
                     const bool                      looks_down,
                     const std::vector<std::string> &names)
  {
    const double huge = std::numeric_limits<double>::max();
    double       top = -huge, bottom = huge;
    for (const SurfaceQuad &quad : quads)
      for (unsigned int i = 0; i < 4 && quad.body == disc_body; ++i)
        {
          top    = std::max(top, quad.corners[i][2]);
          bottom = std::min(bottom, quad.corners[i][2]);
        }
    const double largest = largest_displacement(quads);
    const double scale   = largest > 0. ? drawn_largest / largest : 0.;
    const double near    = 1e-6 * (top - bottom);
    const double height  = height_of_face(quads, disc_body, looks_down, near);

    ShapePicture picture;
    picture.bodies          = bodies_of(quads, names);
    picture.undeformed      = feature_edges(quads, 35.);
    picture.drawn_largest   = largest > 0. ? drawn_largest : 0.;
    picture.face_looks_down = looks_down;
    if (looks_down)
      picture.viewpoint.elevation *= -1.;
    std::vector<double> highest(picture.bodies.size(), -huge);
    for (const SurfaceQuad &quad : quads)
      {
        PicturedBody &body = picture.bodies[quad.body];
        ShapeQuad     flat, deformed;
        bool          on_face = true;
        for (unsigned int i = 0; i < 4; ++i)
          {
            flat.corners[i] = quad.corners[i];
            for (unsigned int d = 0; d < 3; ++d)
              deformed.corners[i][d] =
                quad.corners[i][d] +
                scale * body.times * quad.displacements[i][d];
            flat.values[i] = deformed.values[i] = quad.displacements[i][2];
            on_face = on_face && std::abs(height - quad.corners[i][2]) <= near;
            const double up =
              project(deformed.corners[i], picture.viewpoint)[1];
            if (up > highest[quad.body])
              {
                highest[quad.body] = up;
                body.top           = deformed.corners[i];
              }
          }
        picture.surface.push_back(deformed);
        if (on_face && quad.body == disc_body)
          picture.face.push_back(flat);
        else if (on_face)
          picture.contact.push_back(flat);
      }
    return picture;
  }



  std::vector<SpaceLine>
  feature_edges(const std::vector<SurfaceQuad> &quads, const double degrees)
  {
    // Corners within a nanometre are one.
    using Corner = std::array<long long, 4>;
    struct Edge
    {
      SpaceLine          line;
      std::vector<Place> normals;
    };
    std::map<std::pair<Corner, Corner>, Edge> edges;
    for (const SurfaceQuad &quad : quads)
      {
        const auto corner = [&](const unsigned int i) {
          const Place &x = quad.corners[i % 4];
          return Corner{{quad.body,
                         std::llround(1e9 * x[0]),
                         std::llround(1e9 * x[1]),
                         std::llround(1e9 * x[2])}};
        };
        for (unsigned int i = 0; i < 4; ++i)
          {
            const Corner a = corner(i), b = corner(i + 1);
            if (a == b)
              continue;
            Edge &edge = edges[std::minmax(a, b)];
            edge.line  = {{quad.corners[i], quad.corners[(i + 1) % 4]}};
            edge.normals.push_back(normal_of(quad));
          }
      }
    const double           bound = std::cos(degrees * M_PI / 180.);
    std::vector<SpaceLine> result;
    for (const auto &[corners, edge] : edges)
      {
        const auto  &n = edge.normals;
        const double cosine =
          n.size() == 2
            ? n[0][0] * n[1][0] + n[0][1] * n[1][1] + n[0][2] * n[1][2]
            : -1.;
        if (cosine < bound)
          result.push_back(edge.line);
      }
    return result;
  }
} // namespace squeal
