// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_contact_segments_h
#define squeal_contact_segments_h

#include <deal.II/base/point.h>

#include <functional>
#include <utility>
#include <vector>

namespace squeal
{
  /** A point of a plane curve and its derivative by the curve's parameter. */
  struct CurvePoint
  {
    dealii::Point<2>     x;
    dealii::Tensor<1, 2> derivative;
  };

  /** The curves that pieces of a boundary follow: (number, parameter). */
  using Curves = std::function<CurvePoint(const unsigned int, const double)>;

  /**
   * One piece of the boundary of a plane region, from `start` to the start of
   * the next piece: straight, or along a curve between two parameters.
   */
  struct BoundaryPiece
  {
    static constexpr unsigned int straight = -1u;

    dealii::Point<2> start;
    unsigned int     curve = straight;
    double           first = 0., last = 0.; /**< parameters of the curve */
  };

  /**
   * A plane region by its boundary, counterclockwise. Areas and integrals are
   * signed: what the boundary runs round clockwise counts negative, so that a
   * boundary that touches itself does no harm.
   */
  using Region = std::vector<BoundaryPiece>;

  /** Points x with normal . x + offset >= 0. */
  struct HalfPlane
  {
    dealii::Tensor<1, 2> normal;
    double               offset;
  };

  /** A region with straight edges. */
  Region polygon(const std::vector<dealii::Point<2>> &corners);

  /** Half-planes whose intersection is a convex polygon, its corners given
   * counterclockwise; each edge is moved outwards by @p margin. */
  std::vector<HalfPlane> convex_window(
    const std::vector<dealii::Point<2>> &corners,
    const double                         margin = 0.);

  /**
   * The part of a region inside a convex window (Sutherland and Hodgman,
   * Reentrant polygon clipping, CACM 17, 1974), one half-plane after the
   * other. Points on the border of the window count as inside, without a
   * tolerance: regions that share an edge share every decision, so that their
   * parts add up. A curve is cut where it crosses the border; a piece with both
   * ends on one side counts as being on that side.
   */
  Region clip(Region                        region,
              const std::vector<HalfPlane> &window,
              const Curves                 &curves = {});

  /**
   * Points and weights for integrals over a region: triangles (with one curved
   * side) between the boundary and a centre, @p n_points^2 Gauss points each.
   * Exact for polynomials of degree 2 n_points - 2 where edges are straight.
   */
  std::vector<std::pair<dealii::Point<2>, double>> quadrature(
    const Region      &region,
    const unsigned int n_points,
    const Curves      &curves = {});
} // namespace squeal

#endif
