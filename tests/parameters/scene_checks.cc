// SPDX-License-Identifier: LGPL-2.1-or-later
//
// A scene that cannot stand is refused before anything is computed, by a line
// that names the entry.
#include "example_scene.h"

using namespace squeal;
using namespace squeal::testing;

namespace
{
  /** Refusal of the example scene with one entry changed. */
  void
  check_change_refused(const std::vector<std::string> &overrides,
                       const std::vector<std::string> &parts)
  {
    check_override_refused("example.prm", overrides, parts, overrides.back());
  }



  /** Refusal of the structs of the example, changed in a way that no file
   * can. */
  template <typename Change>
  void
  check_struct_refused(const Change                   &change,
                       const std::vector<std::string> &parts,
                       const std::string              &claim)
  {
    Parameters p = read_parameters("example.prm");
    change(p);
    check_refused([&]() { p.check(); }, parts, claim);
  }



  void
  bodies()
  {
    check_change_refused({"Scene/Body disc/Inner radius = 0.12"},
                         {"example.prm: 'Scene/Body disc/Outer radius'",
                          "greater than 'Inner radius'"});
    check_change_refused({"Scene/Body disc/Cells = 2, 1, 1"},
                         {"at least 3 cells"});
    check_change_refused({"Scene/Body pad/Shape = gmsh"},
                         {"'Scene/Body pad/Mesh file' is empty"});
    check_change_refused(
      {"Scene/Body pad/Shape = gmsh", "Scene/Body pad/Mesh file = missing.msh"},
      {"missing.msh", "no such file"});
    check_change_refused({"Scene/Body pad/Rotation speed = 1"},
                         {"'Scene/Body pad/Rotation speed'"});
    check_struct_refused(
      [](Parameters &p) {
        p.scene = SceneParameters();
        BodyParameters rotor;
        rotor.name           = "rotor";
        rotor.shape          = BodyParameters::Shape::rigid;
        rotor.mass           = 1.;
        rotor.rotation_speed = 5.;
        p.scene.bodies.push_back(rotor);
      },
      {"'Scene/Body rotor/Rotation speed'", "a rigid needs 0"},
      "turning rigid body");
    check_struct_refused(
      [](Parameters &p) {
        BodyParameters coat = p.scene.bodies[0];
        coat.name           = "coat";
        coat.shape          = BodyParameters::Shape::layer;
        coat.layer_body     = p.scene.bodies[0].name;
        coat.layer_face     = "bottom";
        coat.rotation_speed = 5.;
        p.scene.bodies.push_back(coat);
      },
      {"'Scene/Body coat/Rotation speed'", "turns with the body"},
      "layer with a speed of its own");
    check_struct_refused(
      [](Parameters &p) {
        p.scene.bodies[0].rotation_speed = 5.;
        LumpedMassParameters weight;
        weight.name  = "weight";
        weight.body  = p.scene.bodies[0].name;
        weight.point = {{.05, 0., -.005}};
        weight.mass  = 1.;
        p.scene.lumped_masses.push_back(weight);
      },
      {"'Scene/Lumped mass weight/Body'", "turns"},
      "lumped mass on a turning body");
    check_struct_refused(
      [](Parameters &p) {
        p.scene.bodies[0].rotation_speed = 5.;
        TieParameters tie;
        tie.name        = "hub";
        tie.source_body = p.scene.bodies[1].name;
        tie.source_face = "z_min";
        tie.target_body = p.scene.bodies[0].name;
        tie.target_face = "top";
        p.scene.ties.push_back(tie);
      },
      {"'Scene/Tie hub/Target body'", "turns together"},
      "tied bodies of different speeds");
    check_struct_refused(
      [](Parameters &p) {
        BodyParameters hat = p.scene.bodies[0];
        hat.name           = "hat";
        hat.position       = {{0., 0., -.02}};
        hat.rotation_speed = p.scene.bodies[0].rotation_speed = 300.;
        hat.mesh_file = p.scene.bodies[0].mesh_file = "hat.msh";
        // Of mesh files, whose own axis nobody knows before they are read.
        hat.shape = p.scene.bodies[0].shape = BodyParameters::Shape::gmsh;
        hat.rotation_centre                 = Vector3{{.1, 0., 0.}};
        write_text("hat.msh", "");
        p.scene.bodies.push_back(hat);
        TieParameters tie;
        tie.name        = "hat";
        tie.source_body = hat.name;
        tie.source_face = "top";
        tie.target_body = p.scene.bodies[0].name;
        tie.target_face = "bottom";
        p.scene.ties.push_back(tie);
      },
      {"'Scene/Tie hat/Target body'", "about different lines"},
      "tied bodies that turn about two lines");
    const std::string disc = "Scene/Body disc/";
    for (const std::string turns : {"Rotation speed = 300", "Angle = 10"})
      check_change_refused(
        {disc + turns, disc + "Rotation centre = 0.03, 0, 0"},
        {"'Scene/Body disc/Rotation centre'", "own axis"});
    // A bolt goes round with the disc, but has no terms of turning there.
    const std::vector<std::string> bolt = {
      "Scene/Bodies = disc, pad, support, bolt",
      "Scene/Body bolt/Shape = cylinder",
      "Scene/Body bolt/Position = 0.07, 0, 0.1",
      "Scene/Body bolt/Rotation centre = 0, 0, 0"};
    const auto with = [&](const std::string &change) {
      std::vector<std::string> result = bolt;
      result.push_back(change);
      return result;
    };
    read_parameters("example.prm", with("Scene/Body bolt/Angle = 10")).check();
    check_change_refused(with("Scene/Body bolt/Rotation speed = 10"),
                         {"'Scene/Body bolt/Rotation centre'", "own axis"});
    read_parameters(
      "example.prm",
      {disc + "Rotation speed = 300", disc + "Rotation centre = 0, 0, 1"})
      .check();
    write_text("empty_scene.prm", "set Analysis = modes\n");
    check_override_refused("empty_scene.prm",
                           {},
                           {"'Scene/Bodies' is empty"},
                           "scene without bodies");
    write_text("ground.prm",
               "subsection Scene\nset Bodies = ground\n"
               "subsection Body ground\nend\nend\n");
    check_override_refused(
      "ground.prm", {}, {"'Scene/Bodies'", "'ground'"}, "body called ground");
  }



  void
  bodies_made_without_a_file()
  {
    check_struct_refused([](Parameters &p) { p.scene.bodies[1].density = 0.; },
                         {"'Scene/Body pad/Density' = 0"},
                         "zero density");
    check_struct_refused([](Parameters &p) { p.scene.bodies[1].density = -1.; },
                         {"'Scene/Body pad/Density' = -1"},
                         "negative density");
    check_struct_refused(
      [](Parameters &p) { p.scene.bodies[1].poisson_ratio = 0.5; },
      {"'Scene/Body pad/Poisson ratio' = 0.5", "below 0.5"},
      "nu = 0.5");
    check_struct_refused(
      [](Parameters &p) { p.scene.bodies[1].young_modulus = -1.; },
      {"'Scene/Body pad/Young modulus'"},
      "negative modulus");
    check_struct_refused(
      [](Parameters &p) {
        p.scene = SceneParameters();
        BodyParameters slider;
        slider.name  = "slider";
        slider.shape = BodyParameters::Shape::rigid;
        slider.mass  = 0.;
        p.scene.bodies.push_back(slider);
      },
      {"'Scene/Body slider/Mass' = 0"},
      "rigid body without mass");
  }



  void
  orthotropic_materials()
  {
    const std::string body  = "Scene/Body support/";
    const std::string model = body + "Material model = orthotropic";
    read_parameters("example.prm", {model}).check();
    for (const std::string entry :
         {"Young modulus = 1e8", "Poisson ratio = 0.2"})
      check_change_refused(
        {model, body + entry},
        {"'" + body + entry.substr(0, entry.find(" =")) + "'",
         "would be ignored"});
    // nu12 = 2 is fine for a stiff first axis: nu12^2 E2/E1 = 0.4
    const std::string stiff = body + "Young moduli = 1e11, 1e10, 1e10";
    read_parameters("example.prm",
                    {model, stiff, body + "Poisson ratios = 0.1, 0.1, 2"})
      .check();
    check_change_refused({model, body + "Poisson ratios = 0.3, 0.3, 1"},
                         {"'" + body + "Poisson ratios'", "nu12^2 E2/E1 = 1"});
    check_change_refused(
      {model, stiff, body + "Poisson ratios = 0.9, 1.6, 1.6"},
      {"'" + body + "Poisson ratios'", "nu12 nu23 nu13"});
    // an isotropic material at nu = 0.5 is the limit
    check_change_refused({model, body + "Poisson ratios = 0.5, 0.5, 0.5"},
                         {"'" + body + "Poisson ratios'"});
    read_parameters("example.prm",
                    {model, body + "Poisson ratios = 0.499, 0.499, 0.499"})
      .check();
  }



  void
  names_and_faces()
  {
    check_change_refused({"Scene/Tie pad_support/Source body = paad"},
                         {"'Scene/Tie pad_support/Source body' = 'paad'",
                          "disc, pad, support",
                          "did you mean 'pad'?"});
    check_change_refused({"Scene/Load top/Body ="}, {"is empty"});
    check_change_refused({"Scene/Support hub/Face = iner"},
                         {"'Scene/Support hub/Face' = 'iner'",
                          "inner, outer, bottom, top",
                          "did you mean 'inner'?"});
    check_change_refused({"Scene/Load top/Face = side"},
                         {"x_min, x_max, y_min, y_max, z_min, z_max"});
    check_change_refused({"Scene/Load top/Face ="}, {"is empty"});
    check_change_refused({"Scene/Contact pad_disc/Target body = disk"},
                         {"did you mean 'disc'?"});
    check_change_refused({"Scene/Tie pad_support/Target body = pad"},
                         {"source body itself"});
  }



  void
  springs()
  {
    const std::string row = "Scene/Spring row_entry/";
    check_change_refused({row + "Face = z_max"}, {"Kind = area"});
    check_change_refused(
      {row + "First point = 0.1025, -0.005, 0.2"},
      {"'" + row + "First point'", "outside body 'support'"});
    check_change_refused({row + "Number = 1"}, {"'" + row + "Number'"});
    check_change_refused({row + "Last point ="}, {"'" + row + "Last point'"});
    check_change_refused({row + "Stiffness = 0"}, {"do nothing"});
    check_change_refused({row + "Other body = grund"},
                         {"'" + row + "Other body'"});
    check_change_refused({"Scene/Spring guide/Other body = support"},
                         {"'Scene/Spring guide/Other body'", "itself"});
    check_change_refused({"Scene/Spring guide/Stiffnesses = 0, -1, 0"},
                         {"'Scene/Spring guide/Stiffnesses'", "negative"});
    check_change_refused({"Scene/Spring guide/Number = 7"},
                         {"'Scene/Spring guide/Number' = 7", "points"});
    check_change_refused({"Scene/Spring guide/Last point = 0.1, 0, 0.1"},
                         {"'Scene/Spring guide/Last point'", "points"});
    check_change_refused({"Scene/Spring guide/Face = top"},
                         {"'Scene/Spring guide/Face' = 'top'"});
  }



  void
  supports()
  {
    const std::string hub = "Scene/Support hub/";
    check_change_refused({hub + "Kind = components"}, {"'x, y'"});
    check_change_refused({hub + "Components = x"}, {"Kind = components"});
    check_change_refused({hub + "Kind = components", hub + "Components = rx"},
                         {"'rx'", "rigid"});
    check_change_refused({hub + "Kind = components", hub + "Components = x, x"},
                         {"'x' twice"});
    read_parameters("example.prm",
                    {hub + "Kind = components", hub + "Components = x, z"})
      .check();
  }



  void
  damping_is_not_mixed()
  {
    check_change_refused(
      {"Scene/Body pad/Mass damping = 1"},
      {"'Scene/Body pad/Mass damping' = 1", "Model = per part"});
    check_change_refused({"Scene/Spring guide/Structural damping = 0.1"},
                         {"'Scene/Spring guide/Structural damping'"});
    check_change_refused({"Scene/Contact pad_disc/Stiffness damping = 1e-7"},
                         {"'Scene/Contact pad_disc/Stiffness damping'"});
    check_change_refused(
      {"Scene/Damping/Model = per part"},
      {"'Scene/Damping/Mass damping' = 0.02", "Model = whole model"});
    read_parameters("example.prm",
                    {"Scene/Damping/Model = per part",
                     "Scene/Damping/Mass damping = 0",
                     "Scene/Damping/Stiffness damping = 0",
                     "Scene/Body pad/Mass damping = 1"})
      .check();
  }



  /** What has no stiffness of its own has no damping by it. */
  void
  damping_needs_a_stiffness()
  {
    const std::string contact = "Scene/Contact pad_disc/";
    for (const std::string damping :
         {"Structural damping = 1", "Stiffness damping = 1e-3"})
      {
        const std::vector<std::string> per_part = {
          "Scene/Damping/Model = per part",
          "Scene/Damping/Mass damping = 0",
          "Scene/Damping/Stiffness damping = 0",
          contact + damping};
        read_parameters("example.prm", per_part).check();
        for (const std::string formulation : {"mortar", "node to surface"})
          {
            auto all = per_part;
            all.push_back(contact + "Formulation = " + formulation);
            check_change_refused(
              all,
              {"'" + contact + damping.substr(0, damping.find(" =")) + "'",
               "would be ignored",
               formulation});
          }
      }
    for (const auto member : {&BodyParameters::structural_damping,
                              &BodyParameters::stiffness_damping})
      check_struct_refused(
        [&](Parameters &p) {
          p.scene               = SceneParameters();
          p.scene.damping.model = DampingParameters::Model::per_part;
          BodyParameters mass;
          mass.name    = "mass";
          mass.shape   = BodyParameters::Shape::rigid;
          mass.*member = .5;
          p.scene.bodies.push_back(mass);
        },
        {"'Scene/Body mass/St", "= 0.5", "would be ignored", "rigid"},
        "elastic damping of a rigid body");
  }



  /** Entries of a table or of a material that the body does not have. */
  void
  entries_without_effect()
  {
    const std::string pad = "Scene/Body pad/";
    for (const std::string entry : {"Temperature = 400",
                                    "Modulus extrapolation = constant",
                                    "Pressure = 1e6"})
      check_change_refused({pad + entry},
                           {"'" + pad + entry.substr(0, entry.find(" =")) + "'",
                            "Modulus table file"});
    for (const std::string entry : {"Young moduli = 1e9, 1e9, 1e9",
                                    "Shear moduli = 1e9, 1e9, 1e9",
                                    "Poisson ratios = 0.1, 0.1, 0.1",
                                    "Material axis 1 = 0, 0, 1",
                                    "Material axis 2 = 0, 0, 1"})
      check_change_refused({pad + entry},
                           {"'" + pad + entry.substr(0, entry.find(" =")) + "'",
                            "Material model = orthotropic"});
  }



  void
  rigid_scenes()
  {
    const std::string scene =
      "subsection Scene\n"
      "  set Bodies = mass\n"
      "  set Supports = slide\n"
      "  set Springs = vertical\n"
      "  set Contacts = belt\n"
      "  set Lumped masses = extra\n"
      "  subsection Body mass\n    set Shape = rigid\n  end\n"
      "  subsection Support slide\n    set Body = mass\n"
      "    set Kind = components\n    set Components = x, rx, ry, rz\n  end\n"
      "  subsection Spring vertical\n    set Body = mass\n"
      "    set Stiffness = 1e6\n  end\n"
      "  subsection Contact belt\n    set Source body = mass\n"
      "    set Target body = ground\n  end\n"
      "  subsection Lumped mass extra\n    set Body = mass\n"
      "    set Mass = 0.1\n  end\n"
      "end\n";
    write_text("rigid.prm", scene);
    read_parameters("rigid.prm").check();
    check_override_refused("rigid.prm",
                           {"Scene/Contact belt/Source face = bottom"},
                           {"'mass' has no faces"},
                           "face of a rigid body");
    check_override_refused("rigid.prm",
                           {"Scene/Lumped mass extra/Mass = 0"},
                           {"'Scene/Lumped mass extra/Mass'"},
                           "lumped mass of 0");
    check_override_refused("rigid.prm",
                           {"Scene/Spring vertical/Kind = area"},
                           {"'Scene/Spring vertical/Body'", "points"},
                           "elastic bed on a rigid body");
  }
} // namespace

int
main()
{
  write_example();
  read_parameters("example.prm").check();
  bodies();
  bodies_made_without_a_file();
  orthotropic_materials();
  names_and_faces();
  springs();
  supports();
  damping_is_not_mixed();
  damping_needs_a_stiffness();
  entries_without_effect();
  rigid_scenes();
}
