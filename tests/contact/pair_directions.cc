// SPDX-License-Identifier: LGPL-2.1-or-later

// Directions of pairs as wholes: across the sliding two pads of one disc go one
// way, and a contact all round a shaft has no side and no leading edge.

#include <squeal/contact/contact_resultant.h>

#include "check.h"

#include <cmath>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  using Vector = dealii::Tensor<1, 3>;

  void
  add_point(ContactGeometry        &g,
            const dealii::Point<3> &x,
            const Vector           &normal,
            const Vector           &sliding)
  {
    g.points.push_back(x);
    g.areas.push_back(1e-4);
    ContactFrame frame;
    frame.normal     = normal;
    frame.sliding    = sliding;
    frame.transverse = dealii::cross_product_3d(sliding, normal);
    g.frames.push_back(frame);
  }

  /** Four points about x = 0.1 m that slide along y, or as told. */
  ContactGeometry
  pad(const double normal, const Vector &sliding = Vector({0., 1., 0.}))
  {
    ContactGeometry g;
    for (const double x : {.09, .11})
      for (const double y : {-.01, .01})
        add_point(g, {x, y, 0.}, Vector({0., 0., normal}), sliding);
    return g;
  }

  /** Wherever the target slides to, the second axis of the maps goes along with
   * it and the leading edge is where that begins. */
  void
  check_axes(const double  normal,
             const Vector &sliding,
             const bool    is_near_axis)
  {
    const ContactGeometry g = pad(normal, sliding);
    const FaceAxes        axes(g);
    const auto           &d = axes.directions();
    check(d[1] * sliding > (is_near_axis ? .87 : 1. - 1e-12),
          "the second axis goes along the sliding");
    check((dealii::cross_product_3d(d[0], d[1]) - d[2]).norm() < 1e-12,
          "the axes are right-handed");
    check(std::abs(d[2] * Vector({0., 0., normal}) - 1.) < 1e-12,
          "the third is the normal");
    check(std::abs(std::hypot(axes.sliding()[0], axes.sliding()[1]) - 1.) <
            1e-12,
          "one direction of all points is 1 long");
    check(!is_near_axis ||
            std::abs(std::abs(d[1][0]) + std::abs(d[1][1]) - 1.) < 1e-15,
          "near an axis of the scene it is that axis");
    const std::vector<bool> first = leading_edge(g), last = trailing_edge(g);
    double                  begin = 0., end = 0.;
    for (std::size_t j = 0; j < g.points.size(); ++j)
      {
        begin += first[j] ? axes.place(g.points[j])[1] : 0.;
        end += last[j] ? axes.place(g.points[j])[1] : 0.;
      }
    check(begin < end, "the leading edge is where the second axis begins");
  }

  /** Points round a shaft of 20 mm, over @p angle, that slide round it. */
  ContactGeometry
  sleeve(const double angle)
  {
    ContactGeometry    g;
    const unsigned int n = 36;
    for (unsigned int i = 0; i < n; ++i)
      {
        const double a = angle * (i + .5) / n, c = std::cos(a), s = std::sin(a);
        add_point(
          g, {.02 * c, .02 * s, 0.}, Vector({c, s, 0.}), Vector({-s, c, 0.}));
      }
    return g;
  }

  Eigen::VectorXd
  even_forces(const ContactGeometry &g)
  {
    Eigen::VectorXd f = Eigen::VectorXd::Zero(3 * g.points.size());
    for (std::size_t i = 0; i < g.points.size(); ++i)
      f[3 * i] = 10.;
    return f;
  }
} // namespace

int
main()
{
  const ContactGeometry upper = pad(1.), lower = pad(-1.);
  // 5 N outwards on every point of both.
  double sum = 0.;
  for (const ContactGeometry *g : {&upper, &lower})
    {
      Eigen::VectorXd f = Eigen::VectorXd::Zero(12);
      for (unsigned int i = 0; i < 4; ++i)
        f[3 * i + 2] = 5. * g->frames[i].transverse[0];
      sum += transverse_sense(upper, *g) * resultant_force(*g, f)[0];
    }
  check(std::abs(std::abs(sum) - 40.) < 1e-9,
        "what pushes two pads outwards adds up");
  check(looks_to_one_side(upper) && looks_to_one_side(sleeve(M_PI)),
        "a flat face and half a shaft have a side");
  check(!looks_to_one_side(sleeve(2. * M_PI)), "a whole shaft has none");
  check(std::isfinite(
          contact_resultant(upper, even_forces(upper)).leading_edge_factor),
        "a pad has a leading edge");
  const ContactGeometry all_round = sleeve(2. * M_PI);
  const auto r = contact_resultant(all_round, even_forces(all_round));
  check(std::isnan(r.leading_edge_factor), "a shaft has none");
  check(std::abs(r.force[2] - 360.) < 1e-9, "but a normal force");
  // Friction of a ring is what each point has along its own way.
  Eigen::VectorXd f = even_forces(all_round);
  for (std::size_t i = 0; i < all_round.points.size(); ++i)
    f[3 * i + 1] = 3.;
  check(std::abs(resultant_force(all_round, f)[1] - 108.) < 1e-9,
        "the friction of a shaft adds up along its turning");
  check(!slides_one_way(all_round) && slides_one_way(sleeve(M_PI)),
        "a whole shaft slides all round, half of it one way");
  for (const bool at : leading_edge(all_round))
    check(!at, "what slides all round has no leading edge");

  for (const double normal : {1., -1.})
    for (const double degrees : {0., 20., -25., 40., 90., 135., 180., 265.})
      {
        const double a      = degrees * M_PI / 180.,
                     beside = std::abs(std::remainder(degrees, 90.));
        check_axes(
          normal, Vector({std::cos(a), std::sin(a), 0.}), beside < 29.);
      }
  check(FaceAxes(pad(1.)).is_global() &&
          !FaceAxes(pad(1., Vector({0., -1., 0.}))).is_global(),
        "the axes of the scene are those of sliding along y alone");
}
