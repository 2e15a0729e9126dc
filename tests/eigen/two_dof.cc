// SPDX-License-Identifier: LGPL-2.1-or-later

// The two-dof mode coupling of North and Hoffmann as a scene of a rigid body,
// springs and contact: threshold, growth, the effect of damping, and what is
// said about the pair at the exceptional point.

#include "scenes.h"
#include "worst.h"

#include <deal.II/base/mpi.h>

#include <Eigen/Eigenvalues>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  using Complex = std::complex<double>;

  constexpr double k3 = 4. / 3.;

  /** K = [[2, -1 + 4 mu / 3], [-1, 2]] in (y, z): friction drags the mass to
   * +y when it is pressed down, so its entry is +mu k3 and the coupling of the
   * springs -1; the spectrum is that of [[2, 1 - 4 mu / 3], [1, 2]]. */
  SceneParameters
  mode_coupling(const double mu, const double c_y = 0., const double c_z = 0.)
  {
    SceneParameters s;
    BodyParameters  mass;
    mass.name  = "mass";
    mass.shape = BodyParameters::Shape::rigid;
    mass.mass  = 1.;
    s.bodies   = {mass};
    SupportParameters guide;
    guide.name       = "guide";
    guide.body       = "mass";
    guide.kind       = SupportParameters::Kind::components;
    guide.components = {"x", "rx", "ry", "rz"};
    s.supports       = {guide};

    Eigen::MatrixXd springs(2, 2);
    springs << 2., -1., -1., 2. - k3;
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(springs);
    for (int i = 0; i < 2; ++i)
      {
        SpringParameters spring;
        spring.name      = "inclined";
        spring.body      = "mass";
        spring.stiffness = eigen.eigenvalues()[i];
        spring.direction = {
          {0., eigen.eigenvectors()(0, i), eigen.eigenvectors()(1, i)}};
        s.springs.push_back(spring);
      }
    for (const auto &[c, y] : {std::make_pair(c_y, 1.), {c_z, 0.}})
      if (c != 0.)
        {
          SpringParameters dashpot;
          dashpot.name      = "dashpot";
          dashpot.body      = "mass";
          dashpot.dashpot   = c;
          dashpot.direction = {{0., y, 1. - y}};
          s.springs.push_back(dashpot);
        }
    ContactParameters contact;
    contact.name                 = "belt";
    contact.source_body          = "mass";
    contact.target_body          = "ground";
    contact.grid                 = {{1, 1}};
    contact.normal_stiffness     = k3;
    contact.friction_coefficient = mu;
    s.contacts                   = {contact};
    return s;
  }

  ComplexPairs
  solve(const SceneParameters &scene)
  {
    Model model(scene, 1, 1.);
    check(model.pencil.space()->n_global() == 2, "two unknowns");
    return model.solve(band(0., .8));
  }

  /** Growth rate of the closed form, zero below the threshold. */
  double
  growth(const double mu)
  {
    const double b2 = -(1. - mu * k3), a = 2.;
    return b2 <= 0. ? 0. : std::sqrt((std::sqrt(a * a + b2) - a) / 2.);
  }

  void
  test_threshold()
  {
    for (const double mu : {-1., 0., .3, .7499, .7501, 1., 1.5})
      {
        const ComplexPairs pairs = solve(mode_coupling(mu));
        check(pairs.size() == 2, "two pairs");
        Worst sigma;
        for (unsigned int i = 0; i < 2; ++i)
          sigma.add(pairs.sigma(i));
        check(std::abs(sigma.largest() - growth(mu)) < 1e-12,
              "growth at mu = " + number(mu) + ": " + number(sigma.largest()));
      }
    check(std::abs(growth(1.) - 0.2020718) < 1e-7, "published growth rate");

    double below = .5, above = 1.;
    while (above - below > 1e-12)
      {
        const double mu    = .5 * (below + above);
        const auto   pairs = solve(mode_coupling(mu));
        (std::max(pairs.sigma(0), pairs.sigma(1)) > 1e-9 ? above : below) = mu;
      }
    check(std::abs(above - .75) < 1e-10,
          "flutter from mu = 0.75: " + std::to_string(above));
  }

  /** Dashpots: with equal stiffnesses 2 the edge is mu = 0.75 (1 + 2 c_y c_z).
   */
  void
  test_damping()
  {
    for (const auto &[c_y, c_z] : {std::make_pair(.1, .1), {.3, .05}})
      {
        const double edge = .75 * (1. + 2. * c_y * c_z);
        for (const double side : {-1e-4, 0., 1e-4})
          {
            const auto   pairs = solve(mode_coupling(edge + side, c_y, c_z));
            const double sigma = std::max(pairs.sigma(0), pairs.sigma(1));
            check(side == 0. ? std::abs(sigma) < 1e-12 : sigma * side > 0.,
                  "stability edge with dashpots, " + number(side) +
                    " beside it: sigma = " + number(sigma));
          }
      }
  }

  /** North's plate between two pads (prm/minimal/north.prm): contact beside the
   * centre of a body that turns. In (z, theta), M = 1,
   * K = [[2, 0.5], [0.5 - mu, 2.5 - 0.5 mu]]. */
  SceneParameters
  plate_between_pads(const double mu)
  {
    SceneParameters s;
    BodyParameters  plate, pad;
    plate.name  = "plate";
    plate.shape = pad.shape = BodyParameters::Shape::rigid;
    plate.inertia           = {{1., 1., 1.}};
    pad.name                = "pad";
    pad.position            = {{0., .5, 1.}};
    s.bodies                = {plate, pad};
    SupportParameters guide;
    guide.name       = "guide";
    guide.body       = "plate";
    guide.kind       = SupportParameters::Kind::components;
    guide.components = {"x", "y", "ry", "rz"};
    s.supports       = {guide, make_clamp("pad", "")};
    const auto add = [&](const Vector3 &point, const Vector3 &along, double k) {
      SpringParameters spring;
      spring.name        = "spring";
      spring.body        = "plate";
      spring.first_point = spring.last_point = point;
      spring.direction                       = along;
      spring.stiffness                       = k;
      s.springs.push_back(spring);
    };
    add({{0., 0., 0.}}, {{0., 0., 1.}}, 1.);
    add({{0., 0., 1.}}, {{0., 1., 0.}}, 1.125);
    add({{0., 0., -1.}}, {{0., 1., 0.}}, 1.125);
    ContactParameters contact;
    contact.name                 = "upper";
    contact.source_body          = "pad";
    contact.target_body          = "plate";
    contact.normal_stiffness     = .5;
    contact.friction_coefficient = mu;
    s.contacts.push_back(contact);
    contact.name                 = "lower";
    contact.source_body          = "plate";
    contact.contact_point        = {{0., .5, -1.}};
    contact.target_body          = "ground";
    contact.friction_coefficient = -mu;
    s.contacts.push_back(contact);
    return s;
  }

  void
  test_plate_between_pads()
  {
    for (const double mu : {0., .3, .5278, .5279, 1.})
      {
        const ComplexPairs pairs = solve(plate_between_pads(mu));
        check(pairs.size() == 2, "plate: two pairs");
        // lambda^2 = -(A + D)/2 +- sqrt((A - D)^2/4 + B C)
        const double  A = 2., D = 2.5 - .5 * mu, BC = .5 * (.5 - mu);
        const Complex root(std::sqrt(Complex(.25 * (A - D) * (A - D) + BC)));
        for (const double sign : {1., -1.})
          {
            Complex exact = std::sqrt(-.5 * (A + D) + sign * root);
            exact         = exact.imag() < 0. ? -exact : exact;
            check(std::min(std::abs(pairs.lambda[0] - exact),
                           std::abs(pairs.lambda[1] - exact)) < 1e-10,
                  "plate at mu = " + number(mu) + ": lambda = " +
                    number(exact.real()) + " + i " + number(exact.imag()));
          }
      }
    double below = .3, above = 1.;
    while (above - below > 1e-12)
      {
        const double mu    = .5 * (below + above);
        const auto   pairs = solve(plate_between_pads(mu));
        (std::max(pairs.sigma(0), pairs.sigma(1)) > 1e-9 ? above : below) = mu;
      }
    check(std::abs(above - (5. - std::sqrt(20.))) < 1e-10,
          "the plate flutters from mu = 5 - sqrt(20): " +
            std::to_string(above));
  }

  /** lambda^2 = -(2 +- sqrt(-delta)) at mu = 0.75 (1 + delta). */
  void
  test_exceptional_point()
  {
    Worst largest;
    for (const double step : {1e-8, 1e-10})
      for (int i = -4; i <= 4; ++i)
        {
          const double delta = i * step;
          const auto   pairs = solve(mode_coupling(.75 * (1. + delta)));
          check(pairs.size() == 2, "the pair stays a pair");
          const Complex root = std::sqrt(Complex(-delta, 0.));
          Complex a = std::sqrt(-(2. + root)), b = std::sqrt(-(2. - root));
          a                = a.imag() < 0. ? -a : a;
          b                = b.imag() < 0. ? -b : b;
          const auto &l    = pairs.lambda;
          const auto  mean = .5 * (l[0] + l[1]);
          const auto  d2   = .25 * (l[0] - l[1]) * (l[0] - l[1]);
          check(std::abs(mean - .5 * (a + b)) < 1e-13,
                "mean of the pair, delta = " + number(delta));
          check(std::abs(d2 - .25 * (a - b) * (a - b)) < 1e-14,
                "squared half-difference of the pair");
          for (const int j : {0, 1})
            {
              largest.add(pairs.condition[j]);
              const double expected = 1. / (2. * std::sqrt(std::abs(delta)));
              if (i != 0)
                check_close(pairs.condition[j],
                            expected,
                            1e-2,
                            "condition at delta = " + number(delta));
              const bool coalesced = pairs.condition[j] > coalescence_condition;
              check(coalesced == (std::abs(delta) < 2.5e-9),
                    "condition " + number(pairs.condition[j]));
              check(pairs.pair_partner[j] == (coalesced ? 1 - j : -1),
                    "the partner is named where the pair is defective");
              check(pairs.error_estimate[j] < 1e-12,
                    "the pair is judged by mean and half-difference");
            }
        }
    check(largest.largest() > 1e6,
          "huge condition at the exceptional point: " +
            number(largest.largest()));
    const auto apart = solve(mode_coupling(.3));
    check(apart.pair_partner[0] == -1 && apart.condition[0] < 2.,
          "no partner far from it");
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize init(argc, argv, 1);
  test_threshold();
  test_damping();
  test_exceptional_point();
  test_plate_between_pads();
  return 0;
}
