// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/results/shape_view.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace squeal
{
  namespace
  {
    using Point = std::array<double, 3>;

    Point
    difference(const Point &a, const Point &b)
    {
      return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
    }

    Point
    cross(const Point &a, const Point &b)
    {
      return {a[1] * b[2] - a[2] * b[1],
              a[2] * b[0] - a[0] * b[2],
              a[0] * b[1] - a[1] * b[0]};
    }

    double
    dot(const Point &a, const Point &b)
    {
      return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }

    /** Value at (s, t) in [0, 1]^2 of what is given at the corners in order
     * round the quad. */
    double
    bilinear(const double a,
             const double b,
             const double c,
             const double d,
             const double s,
             const double t)
    {
      return (1. - t) * ((1. - s) * a + s * b) + t * (s * c + (1. - s) * d);
    }

    double
    norm_of(const Point &a)
    {
      return std::sqrt(dot(a, a));
    }

    /** Not normalised: its length is twice the area. */
    Point
    normal_of(const ShapeQuad &quad)
    {
      return cross(difference(quad.corners[2], quad.corners[0]),
                   difference(quad.corners[3], quad.corners[1]));
    }

    struct Piece
    {
      ShapeQuad           quad;
      std::array<bool, 4> has_edge;
    };

    /** The piece [i, i + 1]/n x [j, j + 1]/m of @p quad. */
    Piece
    piece_of(const ShapeQuad   &quad,
             const unsigned int i,
             const unsigned int n,
             const unsigned int j,
             const unsigned int m)
    {
      const double s0 = static_cast<double>(i) / n, s1 = (i + 1.) / n;
      const double t0 = static_cast<double>(j) / m, t1 = (j + 1.) / m;
      const std::array<double, 4> s = {{s0, s1, s1, s0}};
      const std::array<double, 4> t = {{t0, t0, t1, t1}};
      const auto                 &c = quad.corners;
      const auto                 &v = quad.values;
      Piece                       piece;
      for (unsigned int k = 0; k < 4; ++k)
        {
          for (unsigned int d = 0; d < 3; ++d)
            piece.quad.corners[k][d] =
              bilinear(c[0][d], c[1][d], c[2][d], c[3][d], s[k], t[k]);
          piece.quad.values[k] = bilinear(v[0], v[1], v[2], v[3], s[k], t[k]);
        }
      piece.has_edge = {{j == 0, i + 1 == n, j + 1 == m, i == 0}};
      return piece;
    }

    /** Cuts @p quads into about @p n_pieces pieces of like size: only such can
     * be sorted by the depth of their centres. */
    std::vector<Piece>
    cut(const std::vector<ShapeQuad> &quads, const std::size_t n_pieces)
    {
      double area = 0.;
      for (const ShapeQuad &quad : quads)
        area += 0.5 * norm_of(normal_of(quad));
      const double size = std::sqrt(area / std::max<std::size_t>(1, n_pieces));
      const auto   n_along = [&](const Point &a, const Point &b) {
        const double n = norm_of(difference(a, b)) / size;
        return static_cast<unsigned int>(std::min(64., std::max(1., n)));
      };
      std::vector<Piece> pieces;
      for (const ShapeQuad &quad : quads)
        {
          const auto        &c = quad.corners;
          const unsigned int n =
            std::max(n_along(c[0], c[1]), n_along(c[3], c[2]));
          const unsigned int m =
            std::max(n_along(c[1], c[2]), n_along(c[0], c[3]));
          for (unsigned int i = 0; i < n; ++i)
            for (unsigned int j = 0; j < m; ++j)
              pieces.push_back(piece_of(quad, i, n, j, m));
        }
      return pieces;
    }

    using CornerKey = std::array<long long, 3>;
    using EdgeKey   = std::pair<CornerKey, CornerKey>;

    struct Edge
    {
      int        n_quads = 0;
      CornerKey  from_key, to_key;
      CanvasLine line;
    };

    using EdgeMap = std::map<EdgeKey, Edge>;

    CornerKey
    corner_key(const Point &p)
    {
      return {{std::llround(p[0] * 1e9),
               std::llround(p[1] * 1e9),
               std::llround(p[2] * 1e9)}};
    }

    /** The side from corner @p i of @p quad, the same from both sides. */
    EdgeKey
    edge_key(const ShapeQuad &quad, const unsigned int i)
    {
      return std::minmax(corner_key(quad.corners[i]),
                         corner_key(quad.corners[(i + 1) % 4]));
    }

    EdgeMap
    edges_of(const std::vector<ShapeQuad> &quads)
    {
      EdgeMap edges;
      for (const ShapeQuad &quad : quads)
        for (unsigned int i = 0; i < 4; ++i)
          {
            const Point &a    = quad.corners[i];
            const Point &b    = quad.corners[(i + 1) % 4];
            Edge        &edge = edges[edge_key(quad, i)];
            ++edge.n_quads;
            edge.from_key = corner_key(a);
            edge.to_key   = corner_key(b);
            edge.line     = {{{{a[0], a[1]}}, {{b[0], b[1]}}}};
          }
      return edges;
    }

    double
    mean_value(const ShapeQuad &quad)
    {
      return 0.25 * (quad.values[0] + quad.values[1] + quad.values[2] +
                     quad.values[3]);
    }

    unsigned int
    scaled_colour(const unsigned int colour, const double factor)
    {
      unsigned int result = 0;
      for (const unsigned int shift : {16, 8, 0})
        {
          const double part = factor * ((colour >> shift) & 0xFF);
          result |= static_cast<unsigned int>(std::min(255., part)) << shift;
        }
      return result;
    }

    /** How bright a face of the given normal is: lit from the eye's upper left,
     * the same on both sides. */
    double
    brightness(const Point &normal, const Viewpoint &viewpoint)
    {
      if (norm_of(normal) == 0.)
        return 1.;
      const Viewpoint light_from{viewpoint.azimuth - 35.,
                                 viewpoint.elevation + 30.};
      const double    degree = std::acos(-1.) / 180.;
      const double    a      = light_from.azimuth * degree;
      const double    e      = light_from.elevation * degree;
      const Point     light{
        std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), std::sin(e)};
      return 0.62 + 0.38 * std::abs(dot(normal, light)) / norm_of(normal);
    }
  } // namespace



  unsigned int
  diverging_colour(const double value)
  {
    // blue, white, red of equal lightness steps on both sides
    static const std::array<std::array<double, 3>, 7> stops = {
      {{{33., 78., 148.}},
       {{76., 141., 196.}},
       {{168., 205., 228.}},
       {{247., 247., 245.}},
       {{246., 186., 152.}},
       {{215., 104., 80.}},
       {{155., 24., 44.}}}};
    const double      place = 3. * (1. + std::min(1., std::max(-1., value)));
    const std::size_t i     = std::min<std::size_t>(5, std::floor(place));
    const double      t     = place - i;
    unsigned int      rgb   = 0;
    for (unsigned int d = 0; d < 3; ++d)
      rgb =
        (rgb << 8) | std::lround((1. - t) * stops[i][d] + t * stops[i + 1][d]);
    return rgb;
  }



  double
  largest_value(const std::vector<ShapeQuad> &quads)
  {
    double largest = 0.;
    for (const ShapeQuad &quad : quads)
      for (const double value : quad.values)
        largest = std::max(largest, std::abs(value));
    return largest;
  }



  std::array<double, 3>
  project(const std::array<double, 3> &point, const Viewpoint &viewpoint)
  {
    const double degree = std::acos(-1.) / 180.;
    const double ca     = std::cos(viewpoint.azimuth * degree);
    const double sa     = std::sin(viewpoint.azimuth * degree);
    const double ce     = std::cos(viewpoint.elevation * degree);
    const double se     = std::sin(viewpoint.elevation * degree);
    const double near   = ca * point[0] + sa * point[1];
    return {-sa * point[0] + ca * point[1],
            ce * point[2] - se * near,
            se * point[2] + ce * near};
  }



  std::vector<CanvasQuad>
  view_from(const std::vector<ShapeQuad> &quads,
            const Viewpoint              &viewpoint,
            const double                  range,
            const std::size_t             n_pieces)
  {
    std::vector<std::pair<double, CanvasQuad>> seen;
    for (const Piece &piece : cut(quads, n_pieces))
      {
        const Point normal = normal_of(piece.quad);
        if (project(normal, viewpoint)[2] < 0.)
          continue;
        CanvasQuad quad;
        double     depth = 0.;
        for (unsigned int i = 0; i < 4; ++i)
          {
            const Point p   = project(piece.quad.corners[i], viewpoint);
            quad.corners[i] = {p[0], p[1]};
            depth += 0.25 * p[2];
          }
        quad.colour = scaled_colour(
          diverging_colour(range > 0. ? mean_value(piece.quad) / range : 0.),
          brightness(normal, viewpoint));
        quad.has_edge = piece.has_edge;
        seen.emplace_back(depth, quad);
      }
    std::stable_sort(
      seen.begin(), seen.end(), [](const auto &a, const auto &b) {
        return a.first < b.first;
      });
    std::vector<CanvasQuad> result;
    for (const auto &[depth, quad] : seen)
      result.push_back(quad);
    return result;
  }



  std::vector<CanvasQuad>
  view_from_above(const std::vector<ShapeQuad> &quads,
                  const double                  range,
                  const std::size_t             n_pieces)
  {
    std::vector<CanvasQuad> result;
    for (const Piece &piece : cut(quads, n_pieces))
      {
        CanvasQuad quad;
        for (unsigned int i = 0; i < 4; ++i)
          quad.corners[i] = {piece.quad.corners[i][0],
                             piece.quad.corners[i][1]};
        quad.colour =
          diverging_colour(range > 0. ? mean_value(piece.quad) / range : 0.);
        result.push_back(quad);
      }
    return result;
  }



  std::vector<CanvasLine>
  zero_lines(const std::vector<ShapeQuad> &quads)
  {
    const EdgeMap           edges = edges_of(quads);
    const double            noise = 1e-9 * largest_value(quads);
    std::vector<CanvasLine> lines;
    for (const ShapeQuad &quad : quads)
      {
        std::array<double, 4> v = quad.values;
        for (double &value : v)
          if (std::abs(value) <= noise)
            value = 0.;
        // an outer edge that is held is zero all along and no nodal line
        const auto is_held = [&](const unsigned int i) {
          return v[i % 4] == 0. && v[(i + 1) % 4] == 0. &&
                 edges.at(edge_key(quad, i % 4)).n_quads == 1;
        };
        const auto point = [&](const unsigned int i, const double t) {
          const Point &a = quad.corners[i % 4], &b = quad.corners[(i + 1) % 4];
          return std::array<double, 2>{
            {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])}};
        };
        std::vector<std::array<double, 2>> crossings;
        for (unsigned int i = 0; i < 4; ++i)
          {
            const double a = v[i], b = v[(i + 1) % 4];
            // zero counts as positive, so that a corner is crossed once
            if ((a < 0.) == (b < 0.) || is_held(i + 1) || is_held(i + 3))
              continue;
            const double t = a / (a - b);
            crossings.push_back(point(i, t));
            if (is_held(i + 2))
              crossings.push_back(point(i + 2, 1. - t));
          }
        for (std::size_t k = 0; k + 1 < crossings.size(); k += 2)
          lines.push_back({crossings[k], crossings[k + 1]});
      }
    return lines;
  }



  std::vector<CanvasPath>
  outline(const std::vector<ShapeQuad> &quads)
  {
    // corners of the outline, where they are and which they are joined to
    std::map<CornerKey, std::array<double, 2>> places;
    std::map<CornerKey, std::set<CornerKey>>   joined;
    for (const auto &[key, edge] : edges_of(quads))
      if (edge.n_quads == 1 && key.first != key.second)
        {
          places[edge.from_key] = edge.line[0];
          places[edge.to_key]   = edge.line[1];
          joined[key.first].insert(key.second);
          joined[key.second].insert(key.first);
        }

    std::vector<CanvasPath> paths;
    while (!joined.empty())
      {
        CornerKey  at = joined.begin()->first;
        CanvasPath path{places[at]};
        while (joined.count(at) > 0)
          {
            const CornerKey next = *joined[at].begin();
            for (const auto &[from, to] :
                 {EdgeKey(at, next), EdgeKey(next, at)})
              {
                joined[from].erase(to);
                if (joined[from].empty())
                  joined.erase(from);
              }
            path.push_back(places[next]);
            at = next;
          }
        paths.push_back(path);
      }
    return paths;
  }
} // namespace squeal
