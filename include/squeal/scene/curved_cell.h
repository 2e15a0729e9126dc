// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_scene_curved_cell_h
#define squeal_scene_curved_cell_h

#include <deal.II/base/point.h>

#include <deal.II/grid/manifold.h>

#include <array>
#include <memory>

namespace squeal
{
  /** Points of a triquadratic cell at the unit coordinates 0, 1/2 and 1, the
   * first coordinate fastest, then the second. m */
  using CellNodes = std::array<dealii::Point<3>, 27>;

  /** The point of a cell of second order at unit coordinates. m */
  dealii::Point<3> point_of_cell(const CellNodes        &nodes,
                                 const dealii::Point<3> &unit);

  /** Its derivatives by the unit coordinates, one a column. m */
  dealii::DerivativeForm<1, 3, 3> gradient_of_cell(
    const CellNodes        &nodes,
    const dealii::Point<3> &unit);

  /** The smallest and the largest determinant of gradient_of_cell(), over the
   * cube of the longest distance of neighbouring corners: at the corners, of
   * curved cells at 6 x 6 x 6 points, as it is a polynomial of degree 5 in each
   * coordinate. Negative: left-handed. */
  std::pair<double, double> range_of_jacobian(const CellNodes &nodes);

  /** How far nodes lie from where the corners alone would have them, over the
   * cell's longest diagonal. */
  double bulge_of(const CellNodes &nodes);

  /** How far the points of a face (x min, x max, y min, ...) lie off the plane
   * of its diagonals, over the longer one. */
  double height_of_face(const CellNodes &nodes, const unsigned int face);

  /** Whether the nodes lie elsewhere than the corners alone would have them. */
  bool is_curved(const CellNodes &nodes);

  /**
   * A cell of second order of the coarse mesh as the chart of all cells,
   * faces and edges that refinement makes of it: a new point is at the mean of
   * the unit coordinates of the points it comes from. Neighbours that share the
   * nodes of a face agree on it, whichever of their charts is asked.
   */
  std::unique_ptr<dealii::Manifold<3>> chart_of_cell(const CellNodes &nodes);
} // namespace squeal

#endif
