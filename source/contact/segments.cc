// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/contact/segments.h>

#include <deal.II/base/quadrature_lib.h>

namespace squeal
{
  namespace
  {
    constexpr unsigned int straight = BoundaryPiece::straight;

    double
    cross(const dealii::Tensor<1, 2> &a, const dealii::Tensor<1, 2> &b)
    {
      return a[0] * b[1] - a[1] * b[0];
    }

    /** Distance from the border times the length of the normal. */
    double
    level(const HalfPlane &h, const dealii::Point<2> &x)
    {
      return h.normal[0] * x[0] + h.normal[1] * x[1] + h.offset;
    }

    struct Crossing
    {
      dealii::Point<2> x;
      double           parameter;
    };

    /** Where a piece between levels of opposite sign crosses the border:
     * Newton's method between ends that keep the signs. */
    Crossing
    crossing(const BoundaryPiece    &piece,
             const dealii::Point<2> &end,
             const HalfPlane        &h,
             const Curves           &curves)
    {
      const double level_0 = level(h, piece.start), level_1 = level(h, end);
      double       share = level_0 / (level_0 - level_1);
      if (piece.curve == straight)
        return {piece.start + share * (end - piece.start), 0.};
      double       low = 0., high = 1.;
      const double span = piece.last - piece.first;
      CurvePoint   p;
      for (unsigned int step = 0; step < 60; ++step)
        {
          p                  = curves(piece.curve, piece.first + share * span);
          const double value = level(h, p.x);
          ((value < 0.) == (level_0 < 0.) ? low : high) = share;
          double next = share - value / (span * (h.normal * p.derivative));
          if (!(next > low && next < high))
            next = .5 * (low + high);
          const double change = std::abs(next - share);
          share               = next;
          if (change < 1e-15)
            break;
        }
      return {p.x, piece.first + share * span};
    }

    Region
    clip_once(const Region &region, const HalfPlane &h, const Curves &curves)
    {
      Region            result;
      const std::size_t n = region.size();
      for (std::size_t i = 0; i < n; ++i)
        {
          const auto &piece         = region[i];
          const auto &end           = region[(i + 1) % n].start;
          const bool  starts_inside = level(h, piece.start) >= 0.,
                     ends_inside    = level(h, end) >= 0.;
          if (starts_inside && ends_inside)
            result.push_back(piece);
          else if (starts_inside != ends_inside)
            {
              const Crossing cut  = crossing(piece, end, h, curves);
              BoundaryPiece  part = piece;
              if (starts_inside)
                {
                  part.last = cut.parameter;
                  result.push_back(part);
                  // On along the border, to where the boundary comes back.
                  result.push_back({cut.x, straight, 0., 0.});
                }
              else
                {
                  part.start = cut.x;
                  part.first = cut.parameter;
                  result.push_back(part);
                }
            }
        }
      return result;
    }
  } // namespace



  Region
  polygon(const std::vector<dealii::Point<2>> &corners)
  {
    Region region;
    for (const auto &x : corners)
      region.push_back({x, straight, 0., 0.});
    return region;
  }



  std::vector<HalfPlane>
  convex_window(const std::vector<dealii::Point<2>> &corners,
                const double                         margin)
  {
    std::vector<HalfPlane> window;
    for (std::size_t i = 0; i < corners.size(); ++i)
      {
        const auto &a = corners[i], &b = corners[(i + 1) % corners.size()];
        const dealii::Tensor<1, 2> along = (b - a) / (b - a).norm();
        const dealii::Tensor<1, 2> inwards({-along[1], along[0]});
        window.push_back(
          {inwards, margin - inwards[0] * a[0] - inwards[1] * a[1]});
      }
    return window;
  }



  Region
  clip(Region                        region,
       const std::vector<HalfPlane> &window,
       const Curves                 &curves)
  {
    for (const auto &h : window)
      region = clip_once(region, h, curves);
    return region;
  }



  std::vector<std::pair<dealii::Point<2>, double>>
  quadrature(const Region      &region,
             const unsigned int n_points,
             const Curves      &curves)
  {
    const dealii::QGauss<1> gauss(n_points);
    const std::size_t       n = region.size();
    dealii::Point<2>        centre;
    for (const auto &piece : region)
      centre += piece.start / double(n);
    std::vector<std::pair<dealii::Point<2>, double>> result;
    for (std::size_t i = 0; i < n; ++i)
      {
        const auto &piece = region[i];
        const auto &end   = region[(i + 1) % n].start;
        for (unsigned int q = 0; q < n_points; ++q)
          {
            const double t = gauss.point(q)[0];
            CurvePoint   p{piece.start + t * (end - piece.start),
                         end - piece.start};
            if (piece.curve != straight)
              {
                const double span = piece.last - piece.first;
                p                 = curves(piece.curve, piece.first + t * span);
                p.derivative *= span;
              }
            const dealii::Tensor<1, 2> arm = p.x - centre;
            const double weight = gauss.weight(q) * cross(arm, p.derivative);
            for (unsigned int r = 0; r < n_points && weight != 0.; ++r)
              {
                const double s = gauss.point(r)[0];
                result.emplace_back(centre + s * arm,
                                    s * gauss.weight(r) * weight);
              }
          }
      }
    return result;
  }
} // namespace squeal
