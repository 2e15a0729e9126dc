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

  /** A polygon that stands for a point. */
  struct PointCell
  {
    std::size_t              point;
    std::vector<PlanarPoint> corners; /**< in order round it */
  };

  /**
   * For each of the points what the @p quads between points, whatever outline
   * they have as a whole, give it: a quarter of each, out to the middles of the
   * edges and of the quad. Quarters that share an edge are one cell; a point in
   * no quad has none.
   */
  std::vector<PointCell> quarter_cells(
    const std::vector<PlanarPoint>                 &points,
    const std::vector<std::array<unsigned int, 4>> &quads);

  /** Edges that belong to one of the @p quads only: the outline. Numbers of
   * points. */
  std::vector<std::array<unsigned int, 2>> outline_of(
    const std::vector<std::array<unsigned int, 4>> &quads);

  /**
   * The polygons between the points whose circumscribed circle holds no other
   * point (Delaunay): triangles, or more corners where more points lie on the
   * circle, as in a grid. Numbers of points, counter-clockwise.
   */
  std::vector<std::vector<int>> delaunay_polygons(
    const std::vector<PlanarPoint> &points);
} // namespace squeal

#endif
