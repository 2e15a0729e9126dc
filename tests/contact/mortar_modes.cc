// SPDX-License-Identifier: LGPL-2.1-or-later

// Mortar contact is the limit of stiff contact springs; mortar ties give the
// modes of conforming ones, exactly so on matching meshes. Contact of round
// faces whose cells meet at nodes of the other face is the same wherever
// rounding puts these: turned, mirrored, and from files in millimetres.

#include "../scene/gmsh_annulus.h"
#include "scenes.h"
#include "worst.h"

#include <deal.II/base/mpi.h>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  Eigen::VectorXcd
  spectrum(const SceneParameters &scene, const double top)
  {
    Model model(scene, 2, top);
    return model.solve(band(500., top)).lambda;
  }

  void
  test_contact()
  {
    SceneParameters springs    = coarse_brake(0.3);
    springs.bodies[0].cells    = {{16, 2, 1}};
    springs.contacts[0].layout = ContactParameters::SpringLayout::quadrature;
    springs.contacts[0].normal_stiffness_per_area = 1e16;
    SceneParameters mortar                        = springs;
    mortar.contacts[0].formulation = ContactParameters::Formulation::mortar;
    const Eigen::VectorXcd a       = spectrum(springs, 6000.),
                           b       = spectrum(mortar, 6000.);
    check(a.size() == b.size() && a.size() > 8,
          "as many pairs with stiff springs as with mortar contact: " +
            std::to_string(a.size()) + ", " + std::to_string(b.size()));
    Worst worst_omega, worst_sigma, largest_sigma;
    for (Eigen::Index i = 0; i < a.size(); ++i)
      {
        worst_omega.add(std::abs(a[i].imag() / b[i].imag() - 1.));
        worst_sigma.add(std::abs(a[i].real() - b[i].real()));
        largest_sigma.add(std::abs(b[i].real()));
      }
    check_below(worst_omega.largest(),
                1e-3,
                "frequencies of stiff springs and of mortar contact agree");
    check_below(worst_sigma.largest() / largest_sigma.largest(),
                1e-2,
                "real parts agree, over the largest of " +
                  number(largest_sigma.largest()) + " 1/s");
  }

  Eigen::VectorXd
  beam(const std::array<unsigned int, 3> &pad,
       const std::array<unsigned int, 3> &support,
       const TieParameters::Kind          kind)
  {
    SceneParameters s;
    s.bodies = {
      make_block("pad", {{0., 0., 0.}}, {{.01, .01, .01}}, pad),
      make_block("support", {{0., 0., .01}}, {{.01, .01, .04}}, support)};
    s.bodies[0].young_modulus = 2e10;
    s.supports                = {make_clamp("pad", "z_min")};
    s.ties = {make_tie("pad", "z_max", "support", "z_min", kind)};
    const Model         model(s, 2, 30e3);
    const UndampedModes modes = undamped_modes(model.pencil, model.inverse);
    return modes.omega_squared.head(modes.n_certified).cwiseSqrt() /
           (2. * M_PI);
  }

  void
  test_tie()
  {
    using Kind        = TieParameters::Kind;
    const auto exact  = beam({{2, 2, 2}}, {{2, 2, 4}}, Kind::conforming),
               mortar = beam({{2, 2, 2}}, {{2, 2, 4}}, Kind::mortar);
    check(exact.size() == mortar.size() && exact.size() >= 4,
          "modes of the tied bodies: " + std::to_string(exact.size()));
    check_below((mortar.array() / exact.array() - 1.)
                  .abs()
                  .maxCoeff<Eigen::PropagateNaN>(),
                1e-9,
                "a mortar tie of matching meshes is the conforming one");

    // Against a finer conforming mesh, the mesh error of the coarser body
    // included: that of conforming coarse meshes is the measure.
    const auto fine  = beam({{3, 3, 2}}, {{3, 3, 4}}, Kind::conforming),
               mixed = beam({{3, 3, 2}}, {{2, 2, 4}}, Kind::automatic),
               other = beam({{2, 2, 2}}, {{3, 3, 4}}, Kind::automatic);
    const auto error = [&](const Eigen::VectorXd &f) {
      check(f.size() == fine.size(), "no mode is lost at a mortar tie");
      return (f.array() / fine.array() - 1.)
        .abs()
        .maxCoeff<Eigen::PropagateNaN>();
    };
    const double coarse = error(exact);
    check_below(
      error(mixed), 1e-3, "a coarse support on a fine pad changes little");
    check_below(error(other),
                1.1 * coarse,
                "a fine support on a coarse pad is no worse than the pad");
    check_below(coarse, 1e-2, "conforming coarse meshes");
  }

  using Point = std::array<double, 3>;

  /** A ring whose curved cells are those of a file, its nodes changed and
   * written in @p unit, m. */
  template <typename Change>
  BodyParameters
  ring(const std::string &name,
       const double       inner,
       const double       outer,
       const unsigned int n,
       const double       unit,
       const Change      &change)
  {
    BodyParameters body;
    body.name         = name;
    body.inner_radius = inner;
    body.outer_radius = outer;
    body.height       = .02;
    body.cells        = {{n, 1, 1}};
    AnnulusFile(body, 27).write_2(name + ".msh", [&](Point x) {
      x = change(x);
      for (double &c : x)
        c /= unit;
      return x;
    });
    body.shape            = BodyParameters::Shape::gmsh;
    body.mesh_file        = name + ".msh";
    body.mesh_length_unit = unit;
    return body;
  }

  /** A shaft that its hub turns round; @p sense of turning about z. */
  template <typename Change>
  Eigen::VectorXcd
  round_spectrum(const double unit, const double sense, const Change &change)
  {
    SceneParameters scene;
    scene.bodies                  = {ring("hub", .08, .12, 16, unit, change),
                                     ring("shaft", .05, .08, 20, unit, change)};
    scene.bodies[0].rotation_axis = {{0., 0., sense}};
    scene.bodies[1].young_modulus = 2e10;
    scene.bodies[1].density       = 2500.;
    scene.supports = {make_clamp("hub", "outer"), make_clamp("shaft", "inner")};
    ContactParameters contact;
    contact.name                 = "bearing";
    contact.source_body          = "shaft";
    contact.source_face          = "outer";
    contact.target_body          = "hub";
    contact.target_face          = "inner";
    contact.formulation          = ContactParameters::Formulation::mortar;
    contact.friction_direction   = ContactParameters::FrictionDirection::slip;
    contact.friction_coefficient = .5;
    contact.sliding_speed        = 1.;
    contact.normal_force         = 500.;
    contact.transverse_slip_term = true;
    scene.contacts               = {contact};
    return spectrum(scene, 17e3);
  }

  void
  test_round_faces()
  {
    const auto same = [](const Point &x) { return x; };
    const auto turn = [](const Point &x) {
      const double c = std::cos(.7), s = std::sin(.7);
      return Point{{c * x[0] - s * x[1], s * x[0] + c * x[1], x[2]}};
    };
    const auto mirror = [](const Point &x) {
      return Point{{x[0], -x[1], x[2]}};
    };
    const Eigen::VectorXcd plain = round_spectrum(1., 1., same);
    Worst                  growth;
    for (const auto &lambda : plain)
      growth.add(lambda.real());
    check_above(growth, -1e6, "the spectrum is finite");
    check(growth.largest() > 1., "friction makes a mode of it grow");
    for (const auto &[text, other] :
         {std::make_pair("from a file in millimetres",
                         round_spectrum(1e-3, 1., same)),
          {"turned", round_spectrum(1., 1., turn)},
          {"mirrored with its turning", round_spectrum(1., -1., mirror)}})
      {
        check(other.size() == plain.size() && plain.size() > 4,
              "as many pairs of the round faces, " +
                std::to_string(plain.size()));
        Worst worst;
        for (const auto &lambda : plain)
          worst.add(smallest((other.array() - lambda).abs()) /
                    std::abs(lambda));
        check_within(worst,
                     1e-9,
                     std::string("round faces have the same spectrum ") + text);
      }
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize init(argc, argv, 1);
  test_tie();
  test_contact();
  test_round_faces();
  return 0;
}
