// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/contact/face_overlap.h>
#include <squeal/contact/segments.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace squeal
{
  namespace
  {
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

    /** The product of a dual, a source and a target function is a polynomial
     * of degree 4 p of the plane where both faces are affine. */
    unsigned int
    n_gauss_points(const unsigned int degree, const bool affine)
    {
      return affine ? 2 * degree + 1 : 2 * degree + 4;
    }

    std::vector<HalfPlane>
    unit_window()
    {
      std::vector<dealii::Point<2>> corners;
      for (unsigned int k = 0; k < 4; ++k)
        corners.push_back(unit_corner(k));
      return convex_window(corners);
    }

    /** Edge k of the target in the order that is counterclockwise seen from the
     * source; 0 <= t <= 1. */
    dealii::Point<2>
    on_target_edge(const unsigned int k, const double t)
    {
      const auto a = unit_corner(4 - k), b = unit_corner(3 - k);
      return a + t * (b - a);
    }

    dealii::Tensor<1, 3>
    along_target_edge(const SurfaceFace::Frame &frame, const unsigned int k)
    {
      const auto direction = unit_corner(3 - k) - unit_corner(4 - k);
      return direction[0] * frame.tangent[0] + direction[1] * frame.tangent[1];
    }

    /** The plane through the source face's centre across its normal. */
    struct AuxiliaryPlane
    {
      explicit AuxiliaryPlane(const SurfaceFace &face)
        : origin(face.point({.5, .5}))
      {
        const auto tangent = face.frame({.5, .5}).tangent[0];
        axis[0]            = tangent / tangent.norm();
        axis[1]            = dealii::cross_product_3d(face.normal(), axis[0]);
      }

      dealii::Point<2>
      project(const dealii::Tensor<1, 3> &x) const
      {
        return {x * axis[0], x * axis[1]};
      }

      dealii::Point<3>
      point(const dealii::Point<2> &x) const
      {
        return origin + x[0] * axis[0] + x[1] * axis[1];
      }

      dealii::Point<3>     origin;
      dealii::Tensor<1, 3> axis[2];
    };

    /** Corners of the source face in the plane, and how far its edges bulge
     * beyond the lines between them. */
    std::vector<HalfPlane>
    window_round(const SurfaceFace &source, const AuxiliaryPlane &plane)
    {
      std::vector<dealii::Point<2>> corners;
      for (unsigned int k = 0; k < 4; ++k)
        corners.push_back(
          plane.project(source.point(unit_corner(k)) - plane.origin));
      std::vector<HalfPlane> window =
        convex_window(corners, .1 * source.diameter());
      double beyond = 0.;
      for (const auto &x : source.nodes())
        {
          const auto in_plane = plane.project(x - plane.origin);
          for (const auto &h : window)
            beyond =
              std::max(beyond,
                       .1 * source.diameter() - h.offset -
                         h.normal[0] * in_plane[0] - h.normal[1] * in_plane[1]);
        }
      for (auto &h : window)
        h.offset += beyond;
      return window;
    }

    /** The outline of the target: pieces along its edges, so short that one
     * seldom leaves and returns between its ends. */
    Region
    target_outline(const SurfaceFace &source,
                   const SurfaceFace &target,
                   const Curves      &curves)
    {
      Region region;
      for (unsigned int k = 0; k < 4; ++k)
        {
          const bool straight =
            source.is_affine() && target.has_straight_edge(3 - k);
          const double length =
            target.point(on_target_edge(k, 0.))
              .distance(target.point(on_target_edge(k, 1.)));
          unsigned int n = 1;
          while (!straight && n < 64 &&
                 (n < 4 || length / n > source.diameter() / 4.))
            n *= 2;
          for (unsigned int i = 0; i < n; ++i)
            {
              const double first = double(i) / n;
              region.push_back({curves(k, first).x,
                                straight ? BoundaryPiece::straight : k,
                                first,
                                (i + 1.) / n});
            }
        }
      return region;
    }

    /** Cuts off what is so far away that the source face, continued, need not
     * reach it. @p curves give unit coordinates; so do the results. */
    Region
    outline_near(const SurfaceFace &source,
                 const SurfaceFace &target,
                 const Curves      &curves)
    {
      const AuxiliaryPlane plane(source);
      const Curves in_plane = [&](const unsigned int k, const double t) {
        const auto f = target.frame(on_target_edge(k, t));
        return CurvePoint{plane.project(f.x - plane.origin),
                          plane.project(along_target_edge(f, k))};
      };
      Region region = clip(target_outline(source, target, in_plane),
                           window_round(source, plane),
                           in_plane);
      for (auto &piece : region)
        if (piece.curve != BoundaryPiece::straight)
          piece.start = curves(piece.curve, piece.first).x;
        else
          {
            const auto p =
              source.project(plane.point(piece.start), source.normal());
            piece.start = p ? p->unit : dealii::Point<2>(unknown, unknown);
          }
      return region;
    }
  } // namespace



  double
  allowed_distance(const SurfaceFace &source, const SurfaceFace &target)
  {
    return 1e-4 * std::max(source.diameter(), target.diameter()) +
           source.bulge() + target.bulge();
  }



  std::vector<OverlapPoint>
  whole_face(const SurfaceFace &source, const unsigned int degree)
  {
    std::vector<dealii::Point<2>> corners;
    for (unsigned int k = 0; k < 4; ++k)
      corners.push_back(unit_corner(k));
    std::vector<OverlapPoint> result;
    for (const auto &[x, weight] : quadrature(
           polygon(corners), n_gauss_points(degree, source.is_affine())))
      result.push_back({x, {}, weight});
    return result;
  }



  std::vector<OverlapPoint>
  face_overlap(const SurfaceFace &source,
               const SurfaceFace &target,
               const unsigned int degree)
  {
    const auto &normal = source.normal();
    if (normal * target.normal() > -.5)
      return {};
    const Curves curves = [&](const unsigned int k, const double t) {
      const auto f = target.frame(on_target_edge(k, t));
      const auto p = source.project(f.x, normal);
      if (!p)
        return CurvePoint{{unknown, unknown}, {}};
      const auto   s      = source.frame(p->unit);
      const auto   along  = along_target_edge(f, k);
      const double volume = s.area_vector() * normal;
      CurvePoint   result{p->unit, {}};
      result.derivative[0] =
        along * dealii::cross_product_3d(s.tangent[1], normal) / volume;
      result.derivative[1] =
        along * dealii::cross_product_3d(normal, s.tangent[0]) / volume;
      return result;
    };
    const Region outline = source.is_affine()
                             ? target_outline(source, target, curves)
                             : outline_near(source, target, curves);
    for (const auto &piece : outline)
      if (!std::isfinite(piece.start[0]))
        return {};
    static const std::vector<HalfPlane> window  = unit_window();
    const Region                        segment = clip(outline, window, curves);
    if (segment.size() < 2)
      return {};

    const double              limit = allowed_distance(source, target);
    std::vector<OverlapPoint> result;
    dealii::Point<2>          guess(.5, .5);
    for (const auto &[x, weight] : quadrature(
           segment,
           n_gauss_points(degree, source.is_affine() && target.is_affine()),
           curves))
      {
        const auto p = target.project(source.point(x), normal, guess);
        if (!p || std::abs(p->distance) > limit)
          return {};
        result.push_back({x, p->unit, weight});
        guess = p->unit;
      }
    return result;
  }
} // namespace squeal
