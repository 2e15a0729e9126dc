// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_results_planar_cells_h
#define squeal_results_planar_cells_h

#include <array>
#include <vector>

namespace squeal
{
  using PlanarPoint = std::array<double, 2>;

  /** Corners of the smallest convex polygon that holds all @p points,
   * counter-clockwise; fewer than three where they lie on a line. */
  std::vector<PlanarPoint> convex_hull(std::vector<PlanarPoint> points);

  /**
   * For each of the points the part of their convex hull that is nearer to it
   * than to any other (its Voronoi cell), at most @p reach to each side in x
   * and y: corners of convex polygons, counter-clockwise, in the unit of the
   * points. Points on one line have squares of that reach instead.
   */
  std::vector<std::vector<PlanarPoint>> nearest_cells(
    const std::vector<PlanarPoint> &points,
    const std::vector<double>      &reach);

  /**
   * The polygons between the points whose circumscribed circle holds no other
   * point (Delaunay): triangles, or more corners where more points lie on the
   * circle, as in a grid. Numbers of points, counter-clockwise.
   */
  std::vector<std::vector<int>> delaunay_polygons(
    const std::vector<PlanarPoint> &points);
} // namespace squeal

#endif
