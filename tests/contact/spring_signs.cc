// SPDX-License-Identifier: LGPL-2.1-or-later

// Signs and sums of the point spring contact: a pressed pad is dragged to +y,
// the disc held back, normal forces repel, slip-rate terms dissipate.

#include "scenes.h"

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
    explicit Forces(const SceneParameters &scene)
      : s(scene)
      , d(s, {}, 1, MPI_COMM_SELF)
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
  test_stick();
  test_slip_direction();
  return 0;
}
