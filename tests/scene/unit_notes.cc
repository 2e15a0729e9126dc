// SPDX-License-Identifier: LGPL-2.1-or-later

// Sizes, moduli and densities of wrong units are named; those of brakes, of
// shim cores and of bodies that stand for more mass are not.

#include <squeal/scene/unit_notes.h>

#include "../check.h"

using namespace squeal;
using namespace squeal::testing;

namespace
{
  SceneParameters
  block(const double edge, const double modulus, const double density)
  {
    SceneParameters scene;
    scene.bodies.resize(1);
    scene.bodies[0].name          = "pad";
    scene.bodies[0].size          = {{edge, .5 * edge, .1 * edge}};
    scene.bodies[0].young_modulus = modulus;
    scene.bodies[0].density       = density;
    return scene;
  }

  void
  check_notes(const SceneParameters &scene, const std::string &part)
  {
    const auto notes = notes_on_units(scene);
    check(notes.size() == 1 && notes[0].find(part) != std::string::npos,
          "one note, with '" + part + "'" +
            (notes.empty() ? "" : ": " + notes[0]));
  }

  void
  bodies()
  {
    check_notes(block(220., 8e9, 2500.), "the scene is 220 m long");
    check_notes(block(2.2e-4, 8e9, 2500.), "the scene is 0.000220 m long");
    check_notes(block(.1, 8000., 2500.),
                "'Scene/Body pad/Young modulus' is 8000 Pa");
    check_notes(block(.1, 2.1e5, 7800.), "is 210000 Pa");
    check_notes(block(.1, 2.1e11, 7.8), "'Scene/Body pad/Density' = 7.8");
    check_notes(block(.1, 2.1e11, 7.8e-9), "'Scene/Body pad/Density' = ");
    for (const auto &scene : {block(.004, 3e5, 900.),
                              block(9., 1e13, 220539.),
                              block(.1, 2.1e11, 30.)})
      check(notes_on_units(scene).empty(), "nothing to say");
    auto wood                     = block(.1, 8e9, 2500.);
    wood.bodies[0].material_model = BodyParameters::MaterialModel::orthotropic;
    wood.bodies[0].young_moduli   = {{1e10, 8e3, 1e9}};
    check_notes(wood, "'Scene/Body pad/Young moduli' goes down to 8000 Pa");
  }

  void
  what_has_no_sizes()
  {
    auto scene = block(220., 8000., 7.8);
    scene.kind = SceneParameters::Kind::matrices;
    check(notes_on_units(scene).empty(), "imported matrices have no sizes");
    scene                 = block(220., 8e9, 2500.);
    scene.bodies[0].shape = BodyParameters::Shape::rigid;
    check(notes_on_units(scene).empty(), "rigid bodies have none either");
    scene.bodies[0].shape     = BodyParameters::Shape::gmsh;
    scene.bodies[0].mesh_file = "missing.msh";
    check(notes_on_units(scene).empty(), "a missing mesh is for the run");
  }

  void
  axes()
  {
    SweepParameters sweep;
    sweep.axes.resize(1);
    auto &axis   = sweep.axes[0];
    axis.entries = {"Scene/Body disc/Density", "Scene/Body pad/Young modulus"};
    axis.from    = {1., 1e4};
    axis.to      = {2., 8e3};
    check(notes_on_units(sweep).size() == 1 &&
            notes_on_units(sweep)[0].find("goes down to 8000 Pa") !=
              std::string::npos,
          "the lower end of an axis of moduli");
    axis.scale  = SweepAxisParameters::Scale::list;
    axis.values = {9e9, 8e9};
    check(notes_on_units(sweep).empty(), "moduli of pads");
    axis.entry_values = {1., 2., 9e9, 9e3};
    check(notes_on_units(sweep).size() == 1, "values of its own");
  }
} // namespace



int
main()
{
  bodies();
  what_has_no_sizes();
  axes();
}
