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

    /** The product of a source and a target function is a polynomial of degree
     * 4 p of the plane where both faces are affine. */
    unsigned int
    n_gauss_points(const unsigned int degree, const bool affine)
    {
      return affine ? 2 * degree + 1 : 2 * degree + 4;
    }

    /** A square of the source face's unit square. */
    struct Patch
    {
      dealii::Point<2> corner;
      double           width;

      dealii::Point<2>
      point(const dealii::Point<2> &x) const
      {
        return corner + width * x;
      }

      std::vector<dealii::Point<2>>
      corners() const
      {
        std::vector<dealii::Point<2>> result;
        for (unsigned int k = 0; k < 4; ++k)
          result.push_back(point(unit_corner(k)));
        return result;
      }
    };

    /** How far edges leave the lines between their corners. m */
    double
    edge_bulge(const SurfaceFace &face)
    {
      double bulge = 0.;
      for (unsigned int k = 0; k < 4; ++k)
        {
          const auto a = unit_corner(k), b = unit_corner(k + 1);
          const auto along = face.point(b) - face.point(a);
          for (const double t : {.25, .5, .75})
            bulge =
              std::max(bulge,
                       dealii::cross_product_3d(
                         face.point(a + t * (b - a)) - face.point(a), along)
                           .norm() /
                         along.norm());
        }
      return bulge;
    }

    /** Squares so small that the edges of each bulge little. */
    std::vector<Patch>
    patches(const SurfaceFace &face)
    {
      unsigned int n = 1;
      if (!face.is_affine())
        {
          const auto   centre = face.frame({.5, .5});
          const double width  = std::min(centre.tangent[0].norm(),
                                        centre.tangent[1].norm()),
                       bulge  = edge_bulge(face);
          while (n < 16 && bulge / n > .12 * width)
            n *= 2;
        }
      std::vector<Patch> result;
      for (unsigned int j = 0; j < n; ++j)
        for (unsigned int i = 0; i < n; ++i)
          result.push_back({{double(i) / n, double(j) / n}, 1. / n});
      return result;
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

    /** A window that just holds a patch: the lines through its corners moved
     * out by what curved edges bulge. Not further, as the parametrisation of a
     * skew face folds back outside of it. */
    std::vector<HalfPlane>
    window_round(const SurfaceFace    &source,
                 const Patch          &patch,
                 const AuxiliaryPlane &plane)
    {
      const auto in_plane = [&](const dealii::Point<2> &unit) {
        return plane.project(source.point(unit) - plane.origin);
      };
      std::vector<dealii::Point<2>> corners;
      for (const auto &corner : patch.corners())
        corners.push_back(in_plane(corner));
      std::vector<HalfPlane> window = convex_window(corners);
      double                 bulge  = 0.;
      for (unsigned int k = 0; k < 4; ++k)
        for (const double t : {.25, .5, .75})
          {
            const auto x = in_plane(patch.point(
              unit_corner(k) + t * (unit_corner(k + 1) - unit_corner(k))));
            for (const auto &h : window)
              bulge = std::max(
                bulge, -h.offset - h.normal[0] * x[0] - h.normal[1] * x[1]);
          }
      for (auto &h : window)
        h.offset += 1.5 * bulge + 1e-3 * corners[0].distance(corners[2]);
      return window;
    }

    /** The outline of the target: pieces along its edges, so short that one
     * seldom leaves and returns between its ends. */
    Region
    target_outline(const SurfaceFace &source,
                   const SurfaceFace &target,
                   const double       width,
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
          while (!straight && n < 64 && (n < 4 || length / n > .25 * width))
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

    /** The outline in unit coordinates of the source, which @p curves give.
     * Where the source face is not affine, what is far from the patch is cut
     * off first, in the auxiliary plane: the face, continued, need not reach
     * it. */
    Region
    outline_near(const SurfaceFace &source,
                 const Patch       &patch,
                 const SurfaceFace &target,
                 const Curves      &curves)
    {
      const double width = patch.width * source.diameter();
      if (source.is_affine())
        return target_outline(source, target, width, curves);
      const AuxiliaryPlane plane(source);
      const Curves in_plane = [&](const unsigned int k, const double t) {
        const auto f = target.frame(on_target_edge(k, t));
        return CurvePoint{plane.project(f.x - plane.origin),
                          plane.project(along_target_edge(f, k))};
      };
      Region region = clip(target_outline(source, target, width, in_plane),
                           window_round(source, patch, plane),
                           in_plane);
      for (auto &piece : region)
        if (piece.curve != BoundaryPiece::straight)
          piece.start = curves(piece.curve, piece.first).x;
        else
          {
            const auto p = source.project(
              plane.point(piece.start), source.normal(), patch.point({.5, .5}));
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
    std::vector<OverlapPoint> result;
    for (const auto &[x, weight] :
         quadrature(polygon(Patch{{0., 0.}, 1.}.corners()),
                    n_gauss_points(degree, source.is_affine())))
      result.push_back({x, {}, weight});
    return result;
  }



  std::vector<OverlapPoint>
  face_overlap(const SurfaceFace &source,
               const SurfaceFace &target,
               const unsigned int degree,
               const double       reach)
  {
    const auto &normal = source.normal();
    if (normal * target.normal() > -.5)
      return {};
    const double limit =
      std::max(allowed_distance(source, target),
               reach * std::max(source.diameter(), target.diameter()));
    const unsigned int n_points =
      n_gauss_points(degree, source.is_affine() && target.is_affine());
    std::vector<OverlapPoint> result;
    for (const Patch &patch : patches(source))
      {
        const auto   middle = patch.point({.5, .5});
        const Curves curves = [&](const unsigned int k, const double t) {
          const auto f = target.frame(on_target_edge(k, t));
          const auto p = source.project(f.x, normal, middle);
          if (!p)
            return CurvePoint{{unknown, unknown}, {}};
          const auto   s      = source.frame(p->unit);
          const auto   along  = along_target_edge(f, k);
          const double volume = s.area_vector() * normal;
          CurvePoint   point{p->unit, {}};
          point.derivative[0] =
            along * dealii::cross_product_3d(s.tangent[1], normal) / volume;
          point.derivative[1] =
            along * dealii::cross_product_3d(normal, s.tangent[0]) / volume;
          return point;
        };
        const Region outline = outline_near(source, patch, target, curves);
        for (const auto &piece : outline)
          if (!std::isfinite(piece.start[0]))
            return {};
        const Region segment =
          clip(outline, convex_window(patch.corners()), curves);
        if (segment.size() < 2)
          continue;
        dealii::Point<2> guess(.5, .5);
        for (const auto &[x, weight] : quadrature(segment, n_points, curves))
          {
            const auto p = target.project(source.point(x), normal, guess);
            if (!p || std::abs(p->distance) > limit)
              return {};
            result.push_back({x, p->unit, weight});
            guess = p->unit;
          }
      }
    return result;
  }
} // namespace squeal
