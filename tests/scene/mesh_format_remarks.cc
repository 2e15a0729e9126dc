// SPDX-License-Identifier: LGPL-2.1-or-later

// Materials of files of Abaqus and Nastran are taken where they are asked for;
// what a file says beside its mesh is named in the log.

#include <squeal/base/exceptions.h>
#include <squeal/parameters/number_access.h>
#include <squeal/scene/mesh_materials.h>

#include "mesh_texts.h"

using namespace squeal;
using namespace squeal::testing;

namespace
{
  using Shape = BodyParameters::Shape;

  void
  materials_of_files()
  {
    SceneParameters scene;
    scene.bodies.resize(2);
    for (auto &body : scene.bodies)
      {
        body.name                    = "steel";
        body.mesh_length_unit        = 1e-3;
        body.mesh_mass_unit          = 1e3;
        body.young_modulus           = 1.;
        body.material_from_mesh_file = true;
      }
    scene.bodies[0].shape      = Shape::abaqus;
    scene.bodies[0].mesh_file  = "steel.inp";
    scene.bodies[0].mesh_faces = {"skin"};
    scene.bodies[1].shape      = Shape::nastran;
    scene.bodies[1].mesh_file  = "steel.bdf";
    std::ofstream("steel.inp") << two_cells;
    std::ofstream("steel.bdf") << one_cell;
    take_mesh_materials(scene);
    for (auto &body : scene.bodies)
      {
        check_close(body.young_modulus, 2.1e11, 1e-14, "E in Pa");
        check_close(body.density, 7850., 1e-13, "rho in kg/m^3");
        check_close(body.poisson_ratio, .3, 1e-15, "nu");
        for (const auto &remark : read_mesh_body(body).remarks)
          check(remark.find("material") == std::string::npos,
                "no disagreement once the material is taken");
      }
    // A section may stand before the cells that it is for.
    const std::string section =
      "*SOLID SECTION, ELSET=both, MATERIAL=STEEL\n,\n";
    const std::string second = "*ELEMENT, TYPE=C3D8R";
    std::ofstream("steel.inp") << replaced_word(
      replaced_word(two_cells, section, ""), second, section + second);
    take_mesh_materials(scene);
    check_close(read_mesh_body(scene.bodies[0]).vertices.back()[2],
                .002,
                1e-15,
                "lengths in m");
    scene.bodies[0].density *= 1.001;
    check(read_mesh_body(scene.bodies[0]).remarks.at(0).find("'Steel'") !=
            std::string::npos,
          "a disagreement is said");
  }

  /** Whatever is read from the entries as used again has the material of the
   * mesh file: scenes with other numbers, the start of these numbers, and the
   * parameter file that a run leaves. */
  void
  materials_of_entries_as_used()
  {
    std::ofstream("steel.inp") << two_cells;
    std::ofstream("steel.prm")
      << "subsection Scene\n set Bodies = steel\n subsection Body steel\n"
         "  set Shape = abaqus\n  set Mesh file = steel.inp\n"
         "  set Mesh length unit = 1e-3\n  set Mesh mass unit = 1e3\n"
         "  set Material from mesh file = true\n end\nend\n";
    const std::string steel = "Scene/Body steel/";
    Parameters        p     = read_parameters("steel.prm");
    take_mesh_materials(p);
    p.check();
    check_close(p.scene.bodies[0].density, 7850., 1e-13, "the file's density");
    const auto has_material = [&](const Parameters &q, const std::string &how) {
      const BodyParameters &a = p.scene.bodies[0], &b = q.scene.bodies[0];
      check(a.young_modulus == b.young_modulus && a.density == b.density &&
              a.poisson_ratio == b.poisson_ratio,
            "the material of the file in " + how);
    };
    has_material(with_value(p, steel + "Position[1]", .1), "a moved scene");
    check(get_number(p, steel + "Density") == p.scene.bodies[0].density,
          "the number of the entry");
    NumberSetter set(p, {steel + "Young modulus"});
    check(set.scene({1e11}).bodies[0].density == p.scene.bodies[0].density,
          "the density where the modulus is set");
    write_used_parameters(p, "used.prm");
    Parameters again = read_parameters("used.prm");
    take_mesh_materials(again);
    again.check();
    has_material(again, "a run that is repeated by its entries");
    check(get_number(with_value(again, steel + "Young modulus", 1e11),
                     steel + "Young modulus") == 1e11,
          "whose modulus may be changed");
    for (const std::string entry :
         {"Young modulus = 1e11", "Poisson ratio = 0.2", "Density = 1000"})
      {
        Parameters both = read_parameters("steel.prm", {steel + entry});
        check_throws<InputError>([&]() { take_mesh_materials(both); },
                                 "would be ignored",
                                 "refused beside it: " + entry);
      }
  }

  /** Densities that are weights over g, and damping, which is the scene's. */
  void
  factors_of_materials()
  {
    std::string text = one_cell;
    text.replace(text.find("MAT1*"),
                 text.find("PLOAD4") - text.find("MAT1*"),
                 "MAT1,3,2.1+5,,.3,7.85-9,,,.02\nPARAM,WTMASS,.5\n");
    std::ofstream("weights.bdf") << text;
    SceneParameters scene;
    scene.bodies.resize(1);
    BodyParameters &body         = scene.bodies[0];
    body.name                    = "steel";
    body.shape                   = Shape::nastran;
    body.mesh_file               = "weights.bdf";
    body.mesh_length_unit        = 1e-3;
    body.mesh_mass_unit          = 1e3;
    body.material_from_mesh_file = true;
    take_mesh_materials(scene);
    check_close(body.density, 3925., 1e-13, "rho by PARAM,WTMASS");
    for (const std::string line : {"PARAM,WTMASS,.5 $ kg",
                                   "PARAM   WTMASS  .5",
                                   " param*  WTMASS          .5"})
      {
        std::ofstream("weights.bdf")
          << "SOL 103\nCEND\nSET 1 = 1,2,3,4,5,6,7,8,9,10,11\n"
          << line << "\nPARAM,G,.03\n"
          << replaced_word(one_cell, "BEGIN BULK", "BEGIN  BULK");
        take_mesh_materials(scene);
        check_close(body.density, 3925., 1e-13, "in the case control: " + line);
        check(read_mesh_body(body).remarks.at(0).find("PARAM,G") !=
                std::string::npos,
              "damping there is said not to be followed");
      }
    std::ofstream("weights.bdf") << text;
    check(read_mesh_body(body).remarks.at(0).find("MAT1 damping (GE)") !=
            std::string::npos,
          "damping of the file is said not to be followed");
  }

  /** Checks that the first remark on a file has every one of the words. */
  void
  names(const std::string              &text,
        const Shape                     shape,
        const std::vector<std::string> &faces,
        const std::vector<std::string> &words)
  {
    const auto remarks = mesh_of(text, shape, "", faces).remarks;
    check(!remarks.empty(), "there is a remark");
    for (const auto &word : words)
      check(remarks[0].find(word) != std::string::npos,
            "not followed is " + word + ": " + remarks[0]);
  }

  /** What else files say of mass, stiffness and damping is named in the log. */
  void
  what_is_not_followed()
  {
    names(replaced_word(two_cells,
                        "*STEP\n",
                        "*Nonstructural mass, elset=low, units=TOTAL MASS\n"
                        "1e-5\n*Foundation\nlow, F1, 5.\n"
                        "*Initial conditions, type=STRESS\nlow, 1.\n"
                        "*Rotary inertia, elset=low\n1., 1., 1.\n*STEP\n"
                        "*Boundary\nfloor, 1, 3\n"
                        "*Modal damping\n1, 10, .01\n"
                        "*Model change, remove\nlow,\n*Cload\n1, 1, 5.\n"
                        "*Dload\nlow, P1, 5.\n*Dsload\nskin, P, 5.\n"),
          Shape::abaqus,
          {"skin"},
          {"*NONSTRUCTURAL MASS",
           "*FOUNDATION",
           "*INITIAL CONDITIONS",
           "*ROTARY INERTIA",
           "*BOUNDARY",
           "*MODAL DAMPING",
           "*MODEL CHANGE",
           "*CLOAD",
           "*DLOAD",
           "*DSLOAD"});
    const std::string text = replaced_word(one_cell,
                                           "ENDDATA",
                                           "SPC1,1,123456,1,THRU,4\n"
                                           "SPCADD,2,1\n"
                                           "PARAM,G,0.05\n"
                                           "PARAM,ALPHA1,0.\n"
                                           "CMASS2,31,1.,1,1\n"
                                           "CDAMP2,33,5.,1,1\n"
                                           "NSM1,4,PSOLID,.5,7\n"
                                           "TEMPD,1,300.\n"
                                           "GRDSET,,,,,,,456\n"
                                           "GRID,22,,9.,9.,9.,,123456\n"
                                           "ENDDATA");
    names(text,
          Shape::nastran,
          {},
          {"SPC1",
           "SPCADD",
           "PARAM,G",
           "CMASS2",
           "CDAMP2",
           "NSM1",
           "TEMPD",
           "GRDSET permanent constraints (PS)",
           "GRID permanent constraints (PS)"});
    names(replaced_word(one_cell, "RBE2,99,1,123,2,3\n", "")
            .replace(one_cell.find("MAT1*"),
                     one_cell.find("PLOAD4") - one_cell.find("MAT1*"),
                     "MAT9,3,1.+11\n"),
          Shape::nastran,
          {},
          {"material '3', which is not isotropic (MAT9)"});
    names(replaced_word(replaced_word(one_cell, "RBE2,99,1,123,2,3\n", ""),
                        "PSOLID  7",
                        "PCOMPS  7"),
          Shape::nastran,
          {},
          {"1 of its cells (first: element 1) no material"});
    check(mesh_of(text, Shape::nastran).remarks[0].find("ALPHA1") ==
            std::string::npos,
          "damping of 0 is none");
  }
} // namespace



int
main()
{
  materials_of_files();
  materials_of_entries_as_used();
  factors_of_materials();
  what_is_not_followed();
}
