// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/scene/curved_cell.h>

#include <deal.II/fe/mapping.h>

#include <algorithm>
#include <limits>

namespace squeal
{
  namespace
  {
    using dealii::Point;
    using dealii::Tensor;

    /** Values and derivatives of the parabolas through 0, 1/2 and 1. */
    struct Parabolas
    {
      explicit Parabolas(const double x)
        : value{{(2. * x - 1.) * (x - 1.),
                 4. * x * (1. - x),
                 x * (2. * x - 1.)}}
        , slope{{4. * x - 3., 4. - 8. * x, 4. * x - 1.}}
      {
      }

      std::array<double, 3> value, slope;
    };

    std::array<Parabolas, 3>
    parabolas(const Point<3> &unit)
    {
      return {{Parabolas(unit[0]), Parabolas(unit[1]), Parabolas(unit[2])}};
    }

    Point<3>
    unit_coordinates(const unsigned int node)
    {
      return {.5 * (node % 3), .5 * (node / 3 % 3), .5 * (node / 9)};
    }

    /** The node at a corner of the cell, x fastest, then y, z. */
    unsigned int
    corner(const unsigned int v)
    {
      return 2 * (v & 1) + 6 * (v >> 1 & 1) + 18 * (v >> 2 & 1);
    }

    double
    longest_edge(const CellNodes &x)
    {
      double longest = 0.;
      for (unsigned int v = 0; v < 8; ++v)
        for (unsigned int d = 0; d < 3; ++d)
          longest =
            std::max(longest, x[corner(v)].distance(x[corner(v | 1 << d)]));
      return longest;
    }

    /** Where the corners alone put a node. */
    Point<3>
    trilinear(const CellNodes &x, const Point<3> &unit)
    {
      Point<3> sum;
      for (unsigned int v = 0; v < 8; ++v)
        {
          double weight = 1.;
          for (unsigned int c = 0; c < 3; ++c)
            weight *= v >> c & 1 ? unit[c] : 1. - unit[c];
          sum += weight * x[corner(v)];
        }
      return sum;
    }



    class CellChart : public dealii::ChartManifold<3>
    {
    public:
      CellChart(const CellNodes &nodes)
        : nodes(nodes)
        , size(longest_edge(nodes))
      {
      }

      std::unique_ptr<dealii::Manifold<3>>
      clone() const override
      {
        return std::make_unique<CellChart>(nodes);
      }

      Point<3>
      push_forward(const Point<3> &unit) const override
      {
        return point_of_cell(nodes, unit);
      }

      dealii::DerivativeForm<1, 3, 3>
      push_forward_gradient(const Point<3> &unit) const override
      {
        return gradient_of_cell(nodes, unit);
      }

      Point<3> pull_back(const Point<3> &x) const override;

    private:
      const CellNodes nodes;
      const double    size;
    };

    Point<3>
    CellChart::pull_back(const Point<3> &x) const
    {
      const auto nearest =
        std::min_element(nodes.begin(), nodes.end(), [&](auto &a, auto &b) {
          return x.distance_square(a) < x.distance_square(b);
        });
      Point<3> unit = unit_coordinates(nearest - nodes.begin());
      if (x.distance(*nearest) < 1e-15 * size)
        return unit;
      // Newton's method converges quadratically: one more step after the first
      // small one leaves rounding errors only.
      bool last_step = false;
      for (unsigned int step = 0; step < 30; ++step)
        {
          const Tensor<2, 3> gradient(gradient_of_cell(nodes, unit));
          if (!(std::abs(determinant(gradient)) > 1e-14 * size * size * size))
            break;
          const Tensor<1, 3> change =
            invert(gradient) * (x - point_of_cell(nodes, unit));
          unit += change;
          if (last_step)
            return unit;
          last_step = change.norm() < 1e-8;
        }
      throw dealii::Mapping<3, 3>::ExcTransformationFailed();
    }
  } // namespace



  Point<3>
  point_of_cell(const CellNodes &nodes, const Point<3> &unit)
  {
    const auto p = parabolas(unit);
    Point<3>   sum;
    for (unsigned int n = 0; n < 27; ++n)
      sum += p[0].value[n % 3] * p[1].value[n / 3 % 3] * p[2].value[n / 9] *
             nodes[n];
    return sum;
  }

  dealii::DerivativeForm<1, 3, 3>
  gradient_of_cell(const CellNodes &nodes, const Point<3> &unit)
  {
    const auto   p = parabolas(unit);
    Tensor<2, 3> gradient;
    for (unsigned int n = 0; n < 27; ++n)
      {
        const std::array<unsigned int, 3> at{{n % 3, n / 3 % 3, n / 9}};
        for (unsigned int d = 0; d < 3; ++d)
          {
            double slope = 1.;
            for (unsigned int c = 0; c < 3; ++c)
              slope *= c == d ? p[c].slope[at[c]] : p[c].value[at[c]];
            for (unsigned int c = 0; c < 3; ++c)
              gradient[c][d] += slope * nodes[n][c];
          }
      }
    return dealii::DerivativeForm<1, 3, 3>(gradient);
  }

  std::pair<double, double>
  range_of_jacobian(const CellNodes &nodes)
  {
    const unsigned int n        = is_curved(nodes) ? 5 : 1;
    double             smallest = std::numeric_limits<double>::max();
    double             largest  = -smallest;
    for (unsigned int k = 0; k <= n; ++k)
      for (unsigned int j = 0; j <= n; ++j)
        for (unsigned int i = 0; i <= n; ++i)
          {
            const Point<3> unit(double(i) / n, double(j) / n, double(k) / n);
            const double   jacobian =
              determinant(Tensor<2, 3>(gradient_of_cell(nodes, unit)));
            if (std::isnan(jacobian))
              return {-jacobian, jacobian};
            smallest = std::min(smallest, jacobian);
            largest  = std::max(largest, jacobian);
          }
    const double edge  = longest_edge(nodes);
    const double scale = 1. / (edge * edge * edge);
    return {smallest * scale, largest * scale};
  }

  double
  bulge_of(const CellNodes &nodes)
  {
    double largest = 0.;
    for (unsigned int n = 0; n < 27; ++n)
      largest = std::max(
        largest, nodes[n].distance(trilinear(nodes, unit_coordinates(n))));
    double diagonal = 0.;
    for (unsigned int v = 0; v < 4; ++v)
      diagonal =
        std::max(diagonal, nodes[corner(v)].distance(nodes[corner(7 - v)]));
    return largest / diagonal;
  }

  double
  height_of_face(const CellNodes &nodes, const unsigned int face)
  {
    std::vector<Point<3>> x;
    for (unsigned int n = 0; n < 27; ++n)
      if (std::array<unsigned int, 3>{{n % 3, n / 3 % 3, n / 9}}[face / 2] ==
          2 * (face % 2))
        x.push_back(nodes[n]);
    const Tensor<1, 3> first = x[8] - x[0], second = x[6] - x[2];
    const Tensor<1, 3> normal = dealii::cross_product_3d(first, second);
    double             height = 0.;
    for (const auto &y : x)
      height = std::max(height, std::abs((y - x[0]) * normal));
    return height / (normal.norm() * std::max(first.norm(), second.norm()));
  }

  bool
  is_curved(const CellNodes &nodes)
  {
    return bulge_of(nodes) > 1e-10;
  }

  std::unique_ptr<dealii::Manifold<3>>
  chart_of_cell(const CellNodes &nodes)
  {
    return std::make_unique<CellChart>(nodes);
  }
} // namespace squeal
