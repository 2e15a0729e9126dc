// SPDX-License-Identifier: LGPL-2.1-or-later

// Signs and sums of the point spring contact: a pressed pad is dragged to +y,
// the disc held back, normal forces repel, slip-rate terms dissipate and have
// the even pressure of the face on any mesh.

#include "turned_block.h"

#include <squeal/contact/contact_geometry.h>

#include <deal.II/base/mpi.h>

#include <map>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  constexpr double mu = 0.4, k_n = 3e6;

  SceneParameters
  pad_on_plate()
  {
    SceneParameters s;
    s.bodies = {
      make_block("pad", {{0., 0., 0.}}, {{.02, .01, .01}}, {{3, 2, 1}}),
      make_block("plate", {{0., 0., -.01}}, {{.05, .05, .01}}, {{2, 2, 1}})};
    ContactParameters c;
    c.name                 = "c";
    c.source_body          = "pad";
    c.source_face          = "z_min";
    c.target_body          = "plate";
    c.target_face          = "z_max";
    c.grid                 = {{5, 4}};
    c.normal_stiffness     = k_n;
    c.friction_coefficient = mu;
    s.contacts             = {c};
    return s;
  }

  /** Forces on the bodies: -K u (or -C u) summed over a body's component. */
  struct Forces
  {
    explicit Forces(const SceneParameters &scene, const unsigned int degree = 1)
      : s(scene)
      , d(s, {}, degree, MPI_COMM_SELF)
      , linearized(linearized_system(d, assemble_bodies(d)))
    {
    }

    Eigen::VectorXd
    unit(const unsigned int body, const unsigned int c) const
    {
      return interpolate(
        d,
        [c](const dealii::Point<3> &) {
          dealii::Tensor<1, 3> u;
          u[c] = 1.;
          return u;
        },
        body);
    }

    /** Force on component @p c of @p body when the other moves by one. */
    double
    operator()(const std::string     &term,
               const unsigned int     body,
               const unsigned int     c,
               const Eigen::VectorXd &u,
               const bool             damping = false) const
    {
      double result = 0.;
      for (const auto &t : linearized.system.terms)
        if (t.name == term)
          {
            const TermCoefficients k = t.coefficients(s);
            result -= (damping ? k.damping : k.stiffness.real()) *
                      unit(body, c).dot(t.matrix->multiply(u).col(0));
          }
      return result;
    }

    /** Power against slip rates of the pad by x, 1/s, in component @p c: what
     * the term has of the second moment of its forces over the face, N m s. */
    double
    moment(const std::string &term, const unsigned int c) const
    {
      const Eigen::VectorXd u = interpolate(
        d,
        [c](const dealii::Point<3> &x) {
          dealii::Tensor<1, 3> v;
          v[c] = x[0];
          return v;
        },
        0);
      double result = 0.;
      for (const auto &t : linearized.system.terms)
        if (t.name == term)
          result +=
            t.coefficients(s).damping * u.dot(t.matrix->multiply(u).col(0));
      return result;
    }

    SceneParameters  s;
    Discretization   d;
    LinearizedSystem linearized;
  };

  void
  check_drag(const Forces &f, const double total, const std::string &layout)
  {
    const Eigen::VectorXd plate_up = f.unit(1, 2), pad_down = -f.unit(0, 2);
    for (const auto &u : {plate_up, pad_down})
      {
        check_close(f("normal contact of c", 0, 2, u),
                    total,
                    1e-12,
                    layout + ": a pressed pad is pushed up");
        check_close(f("normal contact of c", 1, 2, u),
                    -total,
                    1e-12,
                    layout + ": the plate is pushed down");
        check_close(f("friction of c", 0, 1, u),
                    mu * total,
                    1e-12,
                    layout + ": the pad is dragged to +y");
        check_close(f("friction of c", 1, 1, u),
                    -mu * total,
                    1e-12,
                    layout + ": the plate is held back");
        for (const unsigned int c : {0u, 2u})
          check(std::abs(f("friction of c", 0, c, u)) < 1e-12 * total,
                layout + ": friction along y only");
      }
    const Eigen::VectorXd slide = f.unit(1, 1);
    check(std::abs(f("friction of c", 0, 1, slide)) +
              std::abs(f("normal contact of c", 0, 2, slide)) <
            1e-12 * total,
          layout + ": sliding changes no force");
  }

  void
  test_slip_rate_terms()
  {
    SceneParameters s                  = pad_on_plate();
    s.contacts[0].transverse_slip_term = true;
    s.contacts[0].normal_force         = 100.;
    s.contacts[0].sliding_speed        = 0.5;
    s.contacts[0].friction_slope       = -0.02;
    for (const double sign : {1., -1.})
      {
        s.contacts[0].friction_coefficient = sign * mu;
        const Forces          f(s);
        const Eigen::VectorXd across = f.unit(0, 0), along = f.unit(0, 1);
        check_close(f("transverse slip of c", 0, 0, across, true),
                    -mu * 100. / 0.5,
                    1e-12,
                    "slip across the sliding direction is damped by mu N/|V|");
        check_close(f("friction slope of c", 0, 1, along, true),
                    0.02 * 100.,
                    1e-12,
                    "a falling friction law feeds in energy");
        check(std::abs(f("transverse slip of c", 0, 1, along, true)) < 1e-9,
              "the transverse term leaves the sliding direction alone");
      }
  }

  /** An even pressure N / A has the second moment N L^2 / 12 along an edge L,
   * whatever the weights of the Gauss points and the sizes of the cells. */
  void
  test_even_pressure()
  {
    SceneParameters s     = pad_on_plate();
    s.bodies[0].cells     = {{3, 2, 1}};
    const double   length = s.bodies[0].size[0], N = 100., speed = .5;
    BodyParameters uneven   = s.bodies[0];
    uneven.cells            = {{3, 3, 1}};
    uneven                  = make_turned_block(uneven, .5);
    auto &c                 = s.contacts[0];
    c.layout                = ContactParameters::SpringLayout::quadrature;
    c.transverse_slip_term  = true;
    c.normal_force          = N;
    c.sliding_speed         = speed;
    c.friction_slope        = -.02;
    const auto has_pressure = [&](const Forces &f, const std::string &cells) {
      const double square = N * length * length / 12.;
      check_close(f.moment("transverse slip of c", 0),
                  mu / speed * square,
                  1e-12,
                  cells + ": slip across has an even pressure");
      check_close(f.moment("friction slope of c", 1),
                  -.02 * square,
                  1e-12,
                  cells + ": the slope of friction has an even pressure");
    };
    has_pressure(Forces(s, 2), "equal cells");
    s.bodies[0] = uneven;
    for (const unsigned int degree : {1, 2})
      has_pressure(Forces(s, degree),
                   "uneven cells, degree " + std::to_string(degree));
  }

  void
  test_stick()
  {
    SceneParameters s                  = pad_on_plate();
    s.contacts[0].state                = ContactParameters::State::stick;
    s.contacts[0].tangential_stiffness = 7e5;
    const Forces f(s);
    for (const unsigned int c : {0u, 1u})
      check_close(f("sticking contact of c", 0, c, f.unit(0, c)),
                  -20 * 7e5,
                  1e-12,
                  "a sticking pad is held in both directions");
    check(f("friction of c", 0, 1, f.unit(1, 2)) == 0.,
          "no friction force follows the pressure while sticking");
  }

  void
  test_slip_direction()
  {
    SceneParameters s = coarse_brake(mu);
    s.contacts[0].friction_direction =
      ContactParameters::FrictionDirection::slip;
    const Discretization  d(s, {}, 1, MPI_COMM_SELF);
    const ContactGeometry g =
      make_contact_geometry(d, PointEvaluator(d), s.contacts[0]);
    check(g.points.size() == 121, "eleven by eleven points");
    for (unsigned int i = 0; i < g.points.size(); ++i)
      {
        const double r = std::hypot(g.points[i][0], g.points[i][1]);
        const auto  &t = g.frames[i].sliding;
        check(std::abs(t[0] + g.points[i][1] / r) < 1e-14 &&
                std::abs(t[1] - g.points[i][0] / r) < 1e-14 &&
                std::abs(g.speed_ratio[i] - r / .1075) < 1e-3,
              "slip along Omega x r, point " + std::to_string(i));
      }
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize init(argc, argv, 1);
  SceneParameters                          s = pad_on_plate();
  check_drag(Forces(s), 20 * k_n, "grid");
  s.contacts[0].layout = ContactParameters::SpringLayout::quadrature;
  s.contacts[0].normal_stiffness_per_area = 1e12;
  check_drag(Forces(s), 1e12 * .02 * .01, "quadrature");
  test_slip_rate_terms();
  test_even_pressure();
  test_stick();
  test_slip_direction();
  return 0;
}
