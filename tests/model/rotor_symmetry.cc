// SPDX-License-Identifier: LGPL-2.1-or-later

// Which rotors stand still at one angle, and over which angle they repeat: a
// cylinder beside the axis counts, one on it does not; an orthotropic material
// repeats as its constants do, sectors as their moduli. A body with a speed
// that has no axis of symmetry is refused.

#include "scenes.h"

#include <squeal/base/exceptions.h>
#include <squeal/model/rotor_symmetry.h>

#include <deal.II/base/mpi.h>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  /** @p period: "every ..." of what is said of the rotor, empty: nothing. */
  void
  check_said(const SceneParameters &scene,
             const std::string     &period,
             const std::string     &claim)
  {
    const std::string said = frozen_rotors(Discretization(
      scene, squeal::testing::Model::parameters(0), 1, MPI_COMM_SELF));
    check(period.empty() ? said.empty()
                         : said.find("repeats every " + period + " deg") !=
                             std::string::npos,
          claim + ": " + said);
  }

  void
  cylinders_below_the_disc()
  {
    SceneParameters scene = coarse_brake(.3);
    check_said(scene, "", "a disc alone");
    BodyParameters weight;
    weight.name         = "weight";
    weight.shape        = BodyParameters::Shape::cylinder;
    weight.outer_radius = .08;
    weight.position     = {{0., 0., -.02}};
    scene.bodies.push_back(weight);
    scene.ties.push_back(make_tie("weight", "top", "disc", "bottom"));
    check_said(scene, "", "a cylinder on the axis");
    scene.bodies.back().outer_radius = .01;
    scene.bodies.back().position[1]  = .085;
    check_said(scene, "360.00", "a cylinder beside the axis");
    scene.contacts[0].sliding_speed = 0.;
    check_said(scene, "", "the target of a pair at rest");
    scene                           = coarse_brake(.3);
    scene.bodies[0].rotation_centre = Vector3{{.01, 0., 0.}};
    check_said(scene, "360.00", "a disc that runs out");
  }



  void
  orthotropic_discs()
  {
    SceneParameters scene = coarse_brake(.3);
    auto           &disc  = scene.bodies[0];
    disc.material_model   = BodyParameters::MaterialModel::orthotropic;
    disc.young_moduli     = {{1e11, 3e10, 3e10}};
    disc.shear_moduli     = {{1e10, 1e10, 1e10}};
    check_said(scene, "180.00", "stiff along x");
    disc.material_axis_1 = {{1., 0., 1.}};
    check_said(scene, "360.00", "stiff along a tilted direction");
    disc.material_axis_1 = {{1., 0., 0.}};
    disc.young_moduli    = {{1e11, 1e11, 3e10}};
    check_said(scene, "90.000", "as stiff along y");
    disc.shear_moduli[2] = 1e11 / 2.6;
    check_said(scene, "", "the same along all directions in the plane");
  }



  /** A body with a `Rotation speed` needs no contact to be looked at. */
  void
  bodies_that_turn()
  {
    SceneParameters scene;
    scene.bodies = {
      make_block("bar", {{0., 0., 0.}}, {{.1, .04, .02}}, {{4, 2, 1}})};
    scene.bodies[0].rotation_speed = 500.;
    const auto refuse              = [&scene]() {
      refuse_turning_without_axis(Discretization(
        scene, squeal::testing::Model::parameters(0), 1, MPI_COMM_SELF));
    };
    const auto refusal = [&refuse]() -> std::string {
      try
        {
          refuse();
        }
      catch (const InputError &error)
        {
          return error.what();
        }
      return "";
    };
    check(refusal().find("'Scene/Body bar/Rotation speed' = 500") !=
            std::string::npos,
          "a bar that turns is refused: " + refusal());
    scene.bodies[0].rotation_centre = Vector3{{0., .5, 0.}};
    check(!refusal().empty(), "a bar that turns about a line beside it");
    scene.bodies = {
      make_block("plate", {{0., 0., 0.}}, {{.1, .1, .02}}, {{4, 4, 1}})};
    scene.bodies[0].rotation_speed = 500.;
    refuse();
    check_said(scene, "90.000", "a square plate that turns");
    scene.bodies                   = {make_annulus({{12, 2, 1}})};
    scene.bodies[0].rotation_speed = 500.;
    refuse();
    check_said(scene, "", "a disc that turns");
  }



  /** A square plate of three strips with @p moduli, Pa, under a pad. */
  SceneParameters
  strips(const Vector3 &moduli)
  {
    const double    width = .03;
    SceneParameters scene;
    for (unsigned int i = 0; i < 3; ++i)
      {
        scene.bodies.push_back(make_block("strip " + std::to_string(i),
                                          {{width * (i - 1.), 0., -.01}},
                                          {{width, 3. * width, .01}},
                                          {{2, 6, 1}}));
        scene.bodies[i].young_modulus   = moduli[i];
        scene.bodies[i].rotation_centre = Vector3{{0., 0., 0.}};
      }
    scene.bodies.push_back(
      make_block("pad", {{0., .03, 0.}}, {{.01, .01, .01}}, {{1, 1, 1}}));
    scene.ties = {make_tie("strip 0", "x_max", "strip 1", "x_min"),
                  make_tie("strip 1", "x_max", "strip 2", "x_min")};
    ContactParameters contact;
    contact.name                 = "pad";
    contact.source_body          = "pad";
    contact.source_face          = "z_min";
    contact.target_body          = "strip 1";
    contact.target_face          = "z_max";
    contact.friction_direction   = ContactParameters::FrictionDirection::slip;
    contact.friction_coefficient = .3;
    scene.contacts               = {contact};
    return scene;
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize init(argc, argv, 1);
  cylinders_below_the_disc();
  orthotropic_discs();
  bodies_that_turn();
  check_said(strips({{1e11, 1e11, 1e11}}), "90.000", "strips of one material");
  check_said(
    strips({{1e11, 5e10, 1e11}}), "180.00", "a soft strip between two");
  check_said(
    strips({{1e11, 1e11, 5e10}}), "360.00", "a soft strip at the side");
}
