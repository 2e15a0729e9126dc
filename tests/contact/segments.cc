// SPDX-License-Identifier: LGPL-2.1-or-later

// Clipping of plane regions, alone: areas and integrals against closed forms,
// regions that only touch, slivers, curved edges.

#include "check.h"
#include "worst.h"

#include <squeal/contact/segments.h>

#include <algorithm>
#include <random>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  using Point   = dealii::Point<2>;
  using Corners = std::vector<Point>;

  double
  integral(
    const Region                               &region,
    const unsigned int                          n_points,
    const Curves                               &curves = {},
    const std::function<double(const Point &)> &f      = [](const Point &) {
      return 1.;
    })
  {
    double sum = 0.;
    for (const auto &[x, weight] : quadrature(region, n_points, curves))
      sum += weight * f(x);
    return sum;
  }

  double
  common_area(const Corners &a, const Corners &b)
  {
    return integral(clip(polygon(a), convex_window(b)), 1);
  }

  /** Corners on an ellipse, counterclockwise. */
  Corners
  random_polygon(std::mt19937 &random)
  {
    std::uniform_real_distribution<double> uniform(0., 1.);
    const unsigned int                     n = 3 + random() % 6;
    std::vector<double>                    angles;
    for (unsigned int i = 0; i < n; ++i)
      angles.push_back(2. * M_PI * (i + .9 * uniform(random)) / n);
    const Point  centre(uniform(random), uniform(random));
    const double a = .1 + uniform(random), b = .1 + uniform(random),
                 turn = M_PI * uniform(random);
    Corners corners;
    for (const double t : angles)
      {
        const double x = a * std::cos(t), y = b * std::sin(t);
        corners.push_back(centre +
                          Point(x * std::cos(turn) - y * std::sin(turn),
                                x * std::sin(turn) + y * std::cos(turn)));
      }
    return corners;
  }

  double
  shoelace(const Corners &x)
  {
    double sum = 0.;
    for (std::size_t i = 0; i < x.size(); ++i)
      {
        const auto &a = x[i], &b = x[(i + 1) % x.size()];
        sum += .5 * (a[0] * b[1] - b[0] * a[1]);
      }
    return sum;
  }

  void
  check_random_polygons()
  {
    std::mt19937 random(1);
    Worst        whole;
    Worst        exchanged;
    Worst        split;
    unsigned int meeting = 0;
    for (unsigned int trial = 0; trial < 2000; ++trial)
      {
        const Corners a = random_polygon(random), b = random_polygon(random);
        const double  area = shoelace(a), common = common_area(a, b);
        meeting += common > 1e-3 * area && common < .999 * area;
        whole.add(std::abs(integral(polygon(a), 1) - area) / area);
        exchanged.add(std::abs(common - common_area(b, a)) / area);
        // What one half-plane leaves, its complement takes.
        HalfPlane  h = convex_window(b)[0], other = h;
        const auto kept = integral(clip(polygon(a), {h}), 1);
        other.normal *= -1.;
        other.offset *= -1.;
        split.add(
          std::abs(kept + integral(clip(polygon(a), {other}), 1) - area) /
          area);
      }
    check(meeting > 1000,
          "pairs of random polygons that cut one another: " +
            std::to_string(meeting));
    check(whole.largest() < 1e-14,
          "their areas are those of the shoelace formula");
    check(exchanged.largest() < 1e-13,
          "a in b and b in a have the same area, to 1e-13 of it");
    check(split.largest() < 1e-13,
          "both sides of a line add up to the polygon");
  }

  Corners
  square(const double x, const double y, const double width)
  {
    return {{x, y}, {x + width, y}, {x + width, y + width}, {x, y + width}};
  }

  void
  check_closed_forms()
  {
    const Corners unit = square(0., 0., 1.);
    check_close(common_area(square(.7, .4, 1.), unit),
                .3 * .6,
                1e-14,
                "squares that overlap at a corner");
    const double  r = std::sqrt(.5);
    const Corners turned{
      {.5 - r, .5}, {.5, .5 - r}, {.5 + r, .5}, {.5, .5 + r}};
    check_close(common_area(turned, unit),
                2. * (std::sqrt(2.) - 1.),
                1e-14,
                "a square and itself, turned by 45 degrees: an octagon");
    check_close(common_area(unit, unit), 1., 1e-15, "a square and itself");
    check_close(common_area(square(0., .25, .5), unit),
                .25,
                1e-15,
                "a part of an edge in common");
    check(common_area(square(1., 0., 1.), unit) == 0.,
          "an edge in common, from outside: no area");
    check(common_area(square(1., 1., 1.), unit) == 0.,
          "a corner in common: no area");
    check(common_area(square(2., 2., 1.), unit) == 0., "far apart: no area");
    for (const double width : {1e-6, 1e-12, 1e-15})
      {
        // The sliver's width has the rounding error of the coordinate 1.
        const double sliver = common_area(square(1. - width, .2, .5), unit);
        check(std::abs(sliver - .5 * width) < 1e-16,
              "a sliver " + std::to_string(width * 1e15) + "e-15 wide");
      }
    // An L is not convex; the window leaves two separate pieces of it.
    const Region l =
      polygon({{0., 0.}, {3., 0.}, {3., 1.}, {1., 1.}, {1., 3.}, {0., 3.}});
    const Corners window{{.5, 2.}, {2., .5}, {3., 3.}};
    check_close(integral(clip(l, convex_window(window)), 1),
                common_area(window, {{0., 0.}, {3., 0.}, {3., 1.}, {0., 1.}}) +
                  common_area(window, {{0., 1.}, {1., 1.}, {1., 3.}, {0., 3.}}),
                1e-14,
                "two pieces of an L, as of the rectangles it consists of");
  }

  void
  check_polynomials()
  {
    // Over the triangle 0, (1, 0), (0, 1): int x^a y^b = a! b! / (a + b + 2)!
    const Region triangle = clip(polygon(square(0., 0., 1.)),
                                 convex_window({{0., 0.}, {1., 0.}, {0., 1.}}));
    Worst        worst;
    for (unsigned int n = 1; n <= 7; ++n)
      for (unsigned int a = 0; a <= 2 * n - 2; ++a)
        {
          const unsigned int b = 2 * n - 2 - a;
          const double       exact =
            std::tgamma(a + 1.) * std::tgamma(b + 1.) / std::tgamma(a + b + 3.);
          const double sum = integral(triangle, n, {}, [&](const Point &x) {
            return std::pow(x[0], a) * std::pow(x[1], b);
          });
          worst.add(std::abs(sum / exact - 1.));
        }
    check(worst.largest() < 1e-13,
          "n Gauss points are exact for the degree 2 n - 2");
  }

  /** Four quarters of a circle, in @p n pieces each. */
  double
  circle_in_unit_square(const Point       &centre,
                        const double       radius,
                        const unsigned int n,
                        const unsigned int n_points)
  {
    const Curves arcs = [&](const unsigned int quarter, const double t) {
      const double angle = .5 * M_PI * (quarter + t);
      const Point  along(-std::sin(angle), std::cos(angle));
      return CurvePoint{centre +
                          radius * Point(std::cos(angle), std::sin(angle)),
                        .5 * M_PI * radius * along};
    };
    Region circle;
    for (unsigned int quarter = 0; quarter < 4; ++quarter)
      for (unsigned int i = 0; i < n; ++i)
        circle.push_back({arcs(quarter, double(i) / n).x,
                          quarter,
                          double(i) / n,
                          (i + 1.) / n});
    return integral(
      clip(circle, convex_window(square(0., 0., 1.)), arcs), n_points, arcs);
  }

  void
  check_curves()
  {
    check_close(circle_in_unit_square({0., 0.}, .9, 4, 8),
                .25 * M_PI * .81,
                1e-14,
                "a quarter of a circle");
    // A circle that leaves through all four sides: four segments are missing.
    const double r = .6, half_angle = std::acos(.5 / r);
    const double exact =
      M_PI * r * r - 4. * (half_angle * r * r - .5 * std::sqrt(r * r - .25));
    check_close(circle_in_unit_square({.5, .5}, r, 8, 8),
                exact,
                1e-13,
                "a circle that leaves the square through four sides");
  }
} // namespace



int
main()
{
  check_random_polygons();
  check_closed_forms();
  check_polynomials();
  check_curves();
  return 0;
}
