// SPDX-License-Identifier: LGPL-2.1-or-later
//
// A value of the wrong type or out of range is refused with line, entry, value
// and what is allowed; every allowed way of writing arrives in the structs.
#include <squeal/parameters/allowed.h>

#include "example_scene.h"

#include <filesystem>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  void
  check_body_refused(const std::string              &line,
                     const std::vector<std::string> &parts)
  {
    check_text_refused("subsection Scene\n"
                       "  set Bodies = pad\n"
                       "  subsection Body pad\n"
                       "    set " +
                         line + "\n  end\nend\n",
                       parts,
                       line);
  }



  void
  numbers_out_of_range()
  {
    check_body_refused("Poisson ratio = 0.5",
                       {"test.prm:4: 'Scene/Body pad/Poisson ratio' = '0.5'",
                        "a number from 0 to 0.4999"});
    check_body_refused("Poisson ratio = -0.1", {"from 0 to 0.4999"});
    check_body_refused("Density = 0",
                       {"test.prm:4: ", "greater than 0 (kg/m^3)"});
    check_body_refused("Density = -7800", {"greater than 0"});
    check_body_refused("Young modulus = nan", {"'nan'", "(Pa)"});
    check_body_refused("Young modulus = inf", {"'inf'"});
    check_body_refused("Young modulus = 1e400", {"'1e400'"});
    check_body_refused("Cells = 0, 1, 1", {"whole number from 1 to 10000"});
    check_body_refused("Size = 1, -1, 1", {"greater than 0"});
    check_body_refused("Mass = 0", {"greater than 0 (kg)"});
  }



  void
  values_of_another_type()
  {
    check_body_refused("Young modulus = steel", {"'steel'", "a number"});
    check_body_refused("Young modulus =", {"= ''", "a number"});
    check_body_refused("Position = 1, 2", {"3 values separated by commas"});
    check_body_refused("Position = 1 2 3", {"3 values separated by commas"});
    check_body_refused("Cells = 1, 2, 2.5", {"whole number"});
    check_body_refused(
      "Shape = blok",
      {"annulus, block, cylinder, gmsh, abaqus, nastran, layer, rigid",
       "did you mean 'block'?"});
    check_text_refused("\nset Overwrite = maybe\n",
                       {"test.prm:2: ", "true or false"},
                       "no flag");
    check_text_refused("set Analysis = swep\n",
                       {"one of modes, cea, sweep, preload, transient"},
                       "analysis that does not exist");
    check_text_refused("subsection Work precision\n"
                       "set Ladders = degree, degre\nend\n",
                       {"one of degree, refinement, cells, adaptive, basis"},
                       "list with an unknown choice");
  }



  void
  ways_of_writing()
  {
    write_text("test.prm",
               "set Analysis = work   precision\n"
               "set Overwrite = yes\n"
               "subsection Scene\n"
               "  set Bodies = a,b\n"
               "  set Springs = s\n"
               "  set Supports = h\n"
               "  subsection Body a\n"
               "    set Young modulus = 10^10.4\n"
               "    set Position = 1e-2,-10^-2 ,  +.5\n"
               "    set Mesh file = ../meshes/a.msh\n"
               "  end\n"
               "  subsection Body b\n"
               "  end\n"
               "  subsection Spring s\n"
               "    set First point = 1, 2, 3\n"
               "    set Direction = 3, 0, -4\n"
               "  end\n"
               "  subsection Support h\n"
               "    set Kind = components\n"
               "    set Components = x, rz\n"
               "  end\n"
               "end\n"
               "subsection Discretization\n"
               "  set Maximum dofs = 3e5\n"
               "end\n"
               "subsection Work precision\n"
               "  set Values = 1, 0.5\n"
               "end\n");
    const Parameters p = read_parameters("test.prm");
    check(p.analysis == Parameters::Analysis::work_precision, "blanks inside");
    check(p.output.overwrite, "yes");
    check(p.scene.bodies.size() == 2 && p.scene.bodies[0].name == "a" &&
            p.scene.bodies[1].name == "b",
          "names of a list in order");
    check_close(
      p.scene.bodies[0].young_modulus, std::pow(10., 10.4), 1e-15, "power");
    check(p.scene.bodies[0].position == Vector3{{0.01, -0.01, 0.5}}, "vector");
    check(p.scene.bodies[1].young_modulus == 210e9, "default");
    check(p.scene.bodies[0].mesh_file ==
            (std::filesystem::current_path().parent_path() / "meshes/a.msh")
              .string(),
          "a file name starts from the parameter file");
    check(p.scene.springs[0].last_point == Vector3{{1., 2., 3.}},
          "an empty last point is the first");
    check(p.scene.springs[0].direction == Vector3{{0.6, 0., -0.8}},
          "directions are normalised");
    check(p.scene.supports[0].components ==
            std::vector<std::string>({"x", "rz"}),
          "list of choices");
    check(p.discretization.maximum_dofs == 300000, "3e5 is a whole number");
    check(p.work_precision.values == std::vector<double>({1., 0.5}),
          "list of numbers");
  }



  void
  overrides()
  {
    const std::string file = write_example();
    const Parameters  p    = read_parameters(file,
                                         {"Scene/Body pad/Density = 1000",
                                              "Scene/Body pad/Density = 2000",
                                              "Scene/Body pad/Mesh file = a.msh"});
    check(p.scene.bodies[1].density == 2000., "the last override wins");
    check(p.scene.bodies[1].mesh_file ==
            (std::filesystem::current_path() / "a.msh").string(),
          "file names of overrides start from the working directory");
    check_override_refused(
      file,
      {"Scene/Body pad/Density = 0"},
      {"--set: 'Scene/Body pad/Density' = '0'", "greater than 0"},
      "override out of range");
    check_override_refused(file,
                           {"Scene/Bodies = disc, pad"},
                           {"'support' is not in 'Scene/Bodies = disc, pad' "
                            "(--set)"},
                           "override of a list");
  }



  void
  included_values_are_overridden()
  {
    write_example();
    write_text("stiff.prm",
               "subsection Scene\nsubsection Body pad\n"
               "set Young modulus = 1e12\nend\nend\n"
               "include example.prm\n");
    const Parameters p = read_parameters("stiff.prm");
    check(p.scene.bodies[1].young_modulus == 1e12, "including file wins");
    check(p.scene.bodies[1].density == 2500., "the rest is included");
    write_text("wrong.prm",
               "include example.prm\nsubsection Scene\nsubsection Body pad\n"
               "set Density = x\nend\nend\n");
    check_refused([]() { read_parameters("wrong.prm"); },
                  {"wrong.prm:4: "},
                  "wrong value of an including file");
  }



  void
  words()
  {
    using prm::Allowed;
    check(Allowed::number(0., 0.4999).words() == "a number from 0 to 0.4999",
          "both bounds");
    check(Allowed::number().words() == "a number", "no bounds");
    check(Allowed::number(0.).words() == "a number of at least 0", "lower");
    check(Allowed::integer(1, 8).words() == "a whole number from 1 to 8",
          "whole number");
    check(Allowed::one_of({"a", "b"}).words() == "one of a, b", "choice");
  }
} // namespace

int
main()
{
  numbers_out_of_range();
  values_of_another_type();
  ways_of_writing();
  overrides();
  included_values_are_overridden();
  words();
}
