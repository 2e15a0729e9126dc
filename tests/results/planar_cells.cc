// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Cells of points in a plane tile their hull, and polygons between them too.
#include <squeal/results/planar_cells.h>

#include "check.h"
#include "worst.h"

#include <algorithm>
#include <cmath>
#include <random>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  double
  area(const std::vector<PlanarPoint> &polygon)
  {
    double twice = 0.;
    for (std::size_t k = 0; k < polygon.size(); ++k)
      {
        const PlanarPoint &a = polygon[k],
                          &b = polygon[(k + 1) % polygon.size()];
        twice += a[0] * b[1] - a[1] * b[0];
      }
    return 0.5 * twice;
  }

  bool
  holds(const std::vector<PlanarPoint> &polygon, const PlanarPoint &p)
  {
    for (std::size_t k = 0; k < polygon.size(); ++k)
      {
        const PlanarPoint &a = polygon[k],
                          &b = polygon[(k + 1) % polygon.size()];
        if ((b[0] - a[0]) * (p[1] - a[1]) < (b[1] - a[1]) * (p[0] - a[0]))
          return false;
      }
    return polygon.size() > 2;
  }

  std::vector<std::vector<PlanarPoint>>
  corners(const std::vector<std::vector<int>> &polygons,
          const std::vector<PlanarPoint>      &points)
  {
    std::vector<std::vector<PlanarPoint>> result;
    for (const auto &polygon : polygons)
      {
        result.emplace_back();
        for (const int j : polygon)
          result.back().push_back(points[j]);
      }
    return result;
  }

  void
  tile(const std::vector<PlanarPoint> &points, const std::string &what)
  {
    const auto   hull  = convex_hull(points);
    const double whole = area(hull);
    const auto   cells =
      nearest_cells(points, std::vector<double>(points.size(), 100.));
    double sum = 0.;
    for (std::size_t j = 0; j < points.size(); ++j)
      sum += area(cells[j]);
    check_close(sum / whole, 1., 1e-12, what + ": cells fill the hull");

    std::minstd_rand                       generator(3);
    std::uniform_real_distribution<double> uniform(-1., 1.);
    unsigned int                           n_inside = 0, n_right = 0;
    while (n_inside < 200)
      {
        const PlanarPoint p = {uniform(generator), uniform(generator)};
        if (!holds(hull, p))
          continue;
        ++n_inside;
        const auto nearest =
          std::min_element(points.begin(),
                           points.end(),
                           [&](const PlanarPoint &a, const PlanarPoint &b) {
                             return std::hypot(a[0] - p[0], a[1] - p[1]) <
                                    std::hypot(b[0] - p[0], b[1] - p[1]);
                           });
        n_right += holds(cells[nearest - points.begin()], p);
      }
    check(n_right == n_inside, what + ": what is nearest to a point is its");

    sum = 0.;
    Worst least;
    for (const auto &polygon : corners(delaunay_polygons(points), points))
      {
        least.add(area(polygon));
        sum += area(polygon);
      }
    check(least.smallest() > -1e-12, what + ": polygons turn to the left");
    check_close(sum / whole, 1., 1e-5, what + ": polygons fill the hull");
  }
} // namespace

int
main()
{
  std::vector<PlanarPoint> grid, round, drawn;
  for (unsigned int k = 0; k < 30; ++k)
    grid.push_back({0.1 * (k % 6), 0.17 * (k / 6)});
  // A square in a circle, as nodes on a pin.
  for (int i = -2; i <= 2; ++i)
    for (int j = -2; j <= 2; ++j)
      round.push_back({0.2 * i, 0.2 * j});
  for (unsigned int k = 0; k < 16; ++k)
    for (const double radius : {0.7, 0.9})
      round.push_back(
        {radius * std::cos(M_PI * k / 8.), radius * std::sin(M_PI * k / 8.)});
  std::minstd_rand                       generator(7);
  std::uniform_real_distribution<double> uniform(-1., 1.);
  for (unsigned int k = 0; k < 50; ++k)
    drawn.push_back({uniform(generator), uniform(generator)});
  tile(grid, "grid");
  tile(round, "round");
  tile(drawn, "drawn");

  const auto quads = delaunay_polygons(grid);
  check(quads.size() == 20 &&
          std::all_of(quads.begin(),
                      quads.end(),
                      [](const auto &q) { return q.size() == 4; }),
        "a grid has its quads");
  const auto cells =
    nearest_cells(grid, std::vector<double>(grid.size(), 100.));
  check_close(area(cells[0]), 0.05 * 0.085, 1e-12, "a corner of a grid");
  check_close(area(cells[7]), 0.1 * 0.17, 1e-12, "inside a grid");

  // An L of three squares, whose inner corner the hull would cover.
  const std::vector<PlanarPoint>                 l      = {{0., 0.},
                                                           {1., 0.},
                                                           {2., 0.},
                                                           {0., 1.},
                                                           {1., 1.},
                                                           {2., 1.},
                                                           {0., 2.},
                                                           {1., 2.}};
  const std::vector<std::array<unsigned int, 4>> pieces = {
    {{0, 1, 4, 3}}, {{1, 2, 5, 4}}, {{3, 4, 7, 6}}};
  const auto quarters = quarter_cells(l, pieces);
  check(quarters.size() == 8, "one cell a point of the L");
  const double expected[] = {0.25, 0.5, 0.25, 0.5, 0.75, 0.25, 0.25, 0.25};
  for (std::size_t j = 0; j < 8; ++j)
    check_close(area(quarters[j].corners),
                expected[quarters[j].point],
                1e-12,
                "quarters of the L, point " + std::to_string(j));
  check(outline_of(pieces).size() == 8, "outline of the L");
  // Two squares that touch at a corner give it two cells.
  check(
    quarter_cells(
      {{0., 0.}, {1., 0.}, {1., 1.}, {0., 1.}, {2., 1.}, {2., 2.}, {1., 2.}},
      {{{0, 1, 2, 3}}, {{2, 4, 5, 6}}})
        .size() == 8,
    "two cells where squares touch");
  double                                   sum = 0.;
  std::vector<std::array<unsigned int, 4>> grid_quads;
  for (unsigned int j = 0; j < 4; ++j)
    for (unsigned int i = 0; i < 5; ++i)
      grid_quads.push_back(
        {{6 * j + i, 6 * j + i + 1, 6 * j + i + 7, 6 * j + i + 6}});
  for (const auto &cell : quarter_cells(grid, grid_quads))
    sum += area(cell.corners);
  check_close(sum, 0.5 * 0.68, 1e-12, "quarters fill the grid");

  const std::vector<PlanarPoint> line = {{0., 0.}, {1., 1.}, {2., 2.}};
  check(delaunay_polygons(line).empty(), "a line has no polygons");
  check_close(area(nearest_cells(line, {0.5, 0.5, 0.5})[1]),
              1.,
              1e-12,
              "and squares for cells");
  check(delaunay_polygons({{0., 0.}}).empty() &&
          nearest_cells({{0., 0.}}, {1.}).size() == 1,
        "a single point too");
}
