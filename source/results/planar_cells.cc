// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/results/planar_cells.h>

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/adapted/std_array.hpp>
#include <boost/polygon/voronoi.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>

BOOST_GEOMETRY_REGISTER_STD_ARRAY_CS(cs::cartesian)

namespace squeal
{
  namespace
  {
    using Polygon = std::vector<PlanarPoint>;

    /** The part of a convex polygon where normal . x <= bound. */
    Polygon
    clipped(const Polygon     &polygon,
            const PlanarPoint &normal,
            const double       bound)
    {
      const auto outside = [&](const PlanarPoint &p) {
        return normal[0] * p[0] + normal[1] * p[1] - bound;
      };
      Polygon result;
      for (std::size_t k = 0; k < polygon.size(); ++k)
        {
          const PlanarPoint &a = polygon[k],
                            &b = polygon[(k + 1) % polygon.size()];
          const double da = outside(a), db = outside(b);
          if (da <= 0.)
            result.push_back(a);
          if ((da < 0. && db > 0.) || (da > 0. && db < 0.))
            {
              const double s = da / (da - db);
              result.push_back(
                {a[0] + s * (b[0] - a[0]), a[1] + s * (b[1] - a[1])});
            }
        }
      return result;
    }



    /** Around @p centre, @p reach to each side. */
    Polygon
    square(const PlanarPoint &centre, const double reach)
    {
      const double x = centre[0], y = centre[1];
      return {{x - reach, y - reach},
              {x + reach, y - reach},
              {x + reach, y + reach},
              {x - reach, y + reach}};
    }
  } // namespace



  std::vector<PlanarPoint>
  convex_hull(std::vector<PlanarPoint> points)
  {
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    constexpr bool clockwise = false, closed = false;
    boost::geometry::model::ring<PlanarPoint, clockwise, closed> hull;
    boost::geometry::convex_hull(
      boost::geometry::model::multi_point<PlanarPoint>(points.begin(),
                                                       points.end()),
      hull);
    if (boost::geometry::area(hull) <= 0.) // all on one line
      points.resize(std::min<std::size_t>(2, points.size()));
    else
      points.assign(hull.begin(), hull.end());
    return points;
  }



  std::vector<std::vector<PlanarPoint>>
  nearest_cells(const std::vector<PlanarPoint> &points,
                const std::vector<double>      &reach)
  {
    const Polygon        hull = convex_hull(points);
    std::vector<Polygon> cells;
    for (std::size_t j = 0; j < points.size(); ++j)
      {
        const PlanarPoint &p    = points[j];
        Polygon            cell = square(p, reach[j]);
        for (std::size_t k = 0; k < hull.size() && hull.size() > 2; ++k)
          {
            const PlanarPoint &a = hull[k], &b = hull[(k + 1) % hull.size()];
            const PlanarPoint  outwards = {b[1] - a[1], a[0] - b[0]};
            cell =
              clipped(cell, outwards, outwards[0] * a[0] + outwards[1] * a[1]);
          }
        for (std::size_t i = 0; i < points.size() && hull.size() > 2; ++i)
          if (i != j)
            {
              const PlanarPoint &q    = points[i];
              const PlanarPoint  away = {q[0] - p[0], q[1] - p[1]};
              cell                    = clipped(
                cell,
                away,
                0.5 * (away[0] * (p[0] + q[0]) + away[1] * (p[1] + q[1])));
            }
        cells.push_back(cell);
      }
    return cells;
  }



  namespace
  {
    /** The quarter of a quad at one of its corners. */
    struct Quarter
    {
      unsigned int from, to; /**< the corners of the edges that bound it */
      PlanarPoint  centre;   /**< of the quad */
    };

    PlanarPoint
    middle(const PlanarPoint &a, const PlanarPoint &b)
    {
      return {0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])};
    }

    /** Takes from @p quarters those that follow each other round @p point. */
    Polygon
    next_cell(const std::vector<PlanarPoint> &points,
              const std::size_t               point,
              std::vector<Quarter>           &quarters)
    {
      // On the outline the first is one that follows no other.
      const auto follows_none = [&](const Quarter &q) {
        return std::none_of(quarters.begin(),
                            quarters.end(),
                            [&](const Quarter &r) { return r.to == q.from; });
      };
      auto next = std::find_if(quarters.begin(), quarters.end(), follows_none);
      const bool is_on_outline = next != quarters.end();
      if (!is_on_outline)
        next = quarters.begin();
      Polygon cell;
      if (is_on_outline)
        cell.push_back(points[point]);
      unsigned int reached = next->from;
      while (next != quarters.end())
        {
          cell.push_back(middle(points[point], points[next->from]));
          cell.push_back(next->centre);
          reached = next->to;
          quarters.erase(next);
          next =
            std::find_if(quarters.begin(),
                         quarters.end(),
                         [&](const Quarter &q) { return q.from == reached; });
        }
      if (is_on_outline)
        cell.push_back(middle(points[point], points[reached]));
      return cell;
    }
  } // namespace



  std::vector<PointCell>
  quarter_cells(const std::vector<PlanarPoint>                 &points,
                const std::vector<std::array<unsigned int, 4>> &quads)
  {
    std::vector<std::vector<Quarter>> quarters(points.size());
    for (const auto &quad : quads)
      {
        const PlanarPoint centre =
          middle(middle(points[quad[0]], points[quad[2]]),
                 middle(points[quad[1]], points[quad[3]]));
        for (unsigned int k = 0; k < 4; ++k)
          quarters[quad[k]].push_back(
            {quad[(k + 1) % 4], quad[(k + 3) % 4], centre});
      }
    std::vector<PointCell> cells;
    for (std::size_t j = 0; j < points.size(); ++j)
      while (!quarters[j].empty())
        cells.push_back({j, next_cell(points, j, quarters[j])});
    return cells;
  }



  std::vector<std::array<unsigned int, 2>>
  outline_of(const std::vector<std::array<unsigned int, 4>> &quads)
  {
    std::map<std::array<unsigned int, 2>, unsigned int> edges;
    for (const auto &quad : quads)
      for (unsigned int k = 0; k < 4; ++k)
        {
          const unsigned int a = quad[k], b = quad[(k + 1) % 4];
          ++edges[{std::min(a, b), std::max(a, b)}];
        }
    std::vector<std::array<unsigned int, 2>> result;
    for (const auto &[edge, count] : edges)
      if (count == 1)
        result.push_back(edge);
    return result;
  }



  std::vector<std::vector<int>>
  delaunay_polygons(const std::vector<PlanarPoint> &points)
  {
    std::vector<std::vector<int>> result;
    if (convex_hull(points).size() < 3)
      return result;
    // Boost's predicates are exact for integers: a fine lattice.
    PlanarPoint lower = points[0], upper = points[0];
    for (const PlanarPoint &p : points)
      for (unsigned int c = 0; c < 2; ++c)
        {
          lower[c] = std::min(lower[c], p[c]);
          upper[c] = std::max(upper[c], p[c]);
        }
    const double lattice =
      std::max(upper[0] - lower[0], upper[1] - lower[1]) / double(1 << 20);
    std::vector<boost::polygon::point_data<std::int32_t>> sites;
    for (const PlanarPoint &p : points)
      sites.emplace_back(std::lround((p[0] - lower[0]) / lattice),
                         std::lround((p[1] - lower[1]) / lattice));
    boost::polygon::voronoi_diagram<double> diagram;
    boost::polygon::construct_voronoi(sites.begin(), sites.end(), &diagram);
    for (const auto &vertex : diagram.vertices())
      {
        std::vector<int> polygon;
        const auto      *edge = vertex.incident_edge();
        do
          {
            polygon.push_back(edge->cell()->source_index());
            edge = edge->rot_next();
          }
        while (edge != vertex.incident_edge());
        result.push_back(polygon);
      }
    return result;
  }
} // namespace squeal
