// SPDX-License-Identifier: LGPL-2.1-or-later

// Directions of pairs as wholes: across the sliding two pads of one disc go one
// way, and a contact all round a shaft has no side and no leading edge. Of a
// curved face the resultant is the sum of vectors, and friction over pressure
// is mu; the leading edge is all of it, wherever the pad stands.

#include <squeal/contact/contact_resultant.h>
#include <squeal/contact/summed_pairs.h>

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

  /** A grid of points over two lengths, in rows of @p n along the second one. */
  template <typename Place>
  ContactGeometry
  face_of(const unsigned int n, const Place &place)
  {
    ContactGeometry g;
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        {
          const dealii::Point<3> x = place(i / (n - 1.), j / (n - 1.));
          const double           r = std::hypot(x[0], x[1]);
          add_point(
            g, x, Vector({0., 0., 1.}), Vector({-x[1] / r, x[0] / r, 0.}));
          if (i > 0 && j > 0)
            {
              const unsigned int last = n * i + j;
              g.quads.push_back({{last, last - 1, last - n - 1, last - n}});
            }
        }
    return g;
  }

  /** Above a disc that turns about +z: pads that end straight or along a
   * radius, with and without pieces between the points. */
  void
  check_edges()
  {
    constexpr unsigned int n = 5;
    for (const double shift : {0., 1e-7, 1e-5, 1e-3})
      for (const bool is_sector : {false, true})
        {
          ContactGeometry g = face_of(n, [&](const double a, const double b) {
            const double r = .08 + .02 * a, angle = .4 * (b - .5);
            return is_sector ? dealii::Point<3>(
                                 r * std::cos(angle), r * std::sin(angle), 0.)
                             : dealii::Point<3>(r, .02 * (b - .5) + shift, 0.);
          });
          Eigen::VectorXd f = even_forces(g);
          double          mean = 0., first = 0.;
          for (unsigned int k = 0; k < n * n; ++k)
            {
              f[3 * k] = 1. + std::hypot(g.points[k][0], g.points[k][1]) +
                         (k % n == 0 ? 1. : 0.);
              mean += f[3 * k] / (n * n);
              first += k % n == 0 ? f[3 * k] / n : 0.;
            }
          const auto lead = leading_edge(g), trail = trailing_edge(g);
          bool       all = true;
          for (unsigned int k = 0; k < n * n; ++k)
            all =
              all && lead[k] == (k % n == 0) && trail[k] == (k % n == n - 1);
          check(all, "the edges are all of their nodes");
          check_close(contact_resultant(g, f).leading_edge_factor,
                      first / mean,
                      1e-12,
                      "the factor is that of all of them");
          g.quads.clear();
          const auto row = leading_edge(g);
          for (unsigned int k = 0; k < n * n && !is_sector; ++k)
            check(row[k] == (k % n == 0), "without pieces: the outermost row");
        }
  }

  /** Of half a shaft: the sum of vectors; friction of mu along every sliding
   * is mu times the pressure. */
  void
  check_curved_resultant()
  {
    const ContactGeometry g    = sleeve(M_PI);
    const ContactFrame    mean = mean_frame(g);
    constexpr double      mu   = .3;
    Eigen::VectorXd       f    = even_forces(g);
    Vector                sum;
    for (std::size_t k = 0; k < g.points.size(); ++k)
      {
        f[3 * k] += k;
        f[3 * k + 1] = mu * f[3 * k];
        f[3 * k + 2] = 2.;
        sum += f[3 * k] * g.frames[k].normal +
               f[3 * k + 1] * g.frames[k].sliding +
               f[3 * k + 2] * g.frames[k].transverse;
      }
    const auto force = resultant_force(g, f);
    check_close(force[0], sum * mean.transverse, 1e-12, "across");
    check_close(force[1], sum * mean.sliding, 1e-12, "along");
    check_close(force[2], sum * mean.normal, 1e-12, "normal");
    const Eigen::VectorXd sums = sum_rows(g) * f;
    check_close(sums[1] / sums[0], mu, 1e-12, "friction over pressure");
    const auto r = contact_resultant(g, f);
    check_close(r.mean_pressure,
                sums[0] / (1e-4 * g.points.size()),
                1e-12,
                "the mean pressure is that of the nodes");
    // A flat face has one normal: nothing else is to change there.
    const ContactGeometry flat    = pad(-1.);
    Eigen::VectorXd       of_flat = even_forces(flat);
    of_flat[1] = of_flat[5] = 7.;
    const auto flat_force   = resultant_force(flat, of_flat);
    check(flat_force[0] == 7. * flat.frames[1].transverse[0] *
                             mean_frame(flat).transverse[0] &&
            flat_force[1] == 7. && flat_force[2] == 40.,
          "a flat face has the sums of its nodes");
  }

  /** An abutment at rest that comes first is not what pads are added up by. */
  void
  check_sums_of_pairs()
  {
    ContactGeometry abutment;
    add_point(
      abutment, {.1, .02, 0.}, Vector({0., -1., 0.}), Vector({0., 0., 1.}));
    ContactParameters rest, upper, lower;
    rest.name           = "abutment";
    upper.name          = "upper";
    lower.name          = "lower";
    rest.sliding_speed  = 0.;
    upper.sliding_speed = lower.sliding_speed = 1.;
    using List                                = std::vector<double>;
    check(transverse_senses(ContactNodes({rest, upper, lower},
                                         {abutment, pad(1.), pad(-1.)})) ==
            List({0., 1., -1.}),
          "against the first pad, the abutment in front");
    check(transverse_senses(ContactNodes({upper, lower, rest},
                                         {pad(1.), pad(-1.), abutment})) ==
            List({1., -1., 0.}),
          "and behind");
  }

} // namespace

int
main()
{
  check_edges();
  check_curved_resultant();
  check_sums_of_pairs();
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
