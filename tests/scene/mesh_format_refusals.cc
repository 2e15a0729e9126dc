// SPDX-License-Identifier: LGPL-2.1-or-later

// Files of Abaqus and Nastran that cannot be used are refused in one line that
// names the file, and so is whatever is left of them when they are damaged.

#include <squeal/base/exceptions.h>
#include <squeal/scene/mesh_materials.h>

#include "mesh_texts.h"

using namespace squeal;
using namespace squeal::testing;

namespace
{
  using Shape = BodyParameters::Shape;

  const std::string inp = R"(*Part, name=Cube
*Node
1, 0, 0, 0
2, 1, 0, 0
3, 1, 1, 0
4, 0, 1, 0
5, 0, 0, 1
6, 1, 0, 1
7, 1, 1, 1
8, 0, 1, 1
*Element, type=C3D8
1, 1, 2, 3, 4, 5, 6, 7, 8
*Elset, elset=all
1,
*Nset, nset=floor, generate
1, 4, 1
*Surface, name=top
all, S2
*End Part
*Assembly, name=A
*Instance, name=I, part=Cube
1., 0., 0.
*End Instance
*End Assembly
*Material, name=M
*Elastic
2e11, .3
*Density
7800.,
*Step
*End Step
)";

  const std::string bdf = R"(BEGIN BULK
GRID    1               0.      0.      0.
GRID    2               1.      0.      0.
GRID    3               1.      1.      0.
GRID    4               0.      1.      0.
GRID    5               0.      0.      1.
GRID    6               1.      0.      1.
GRID    7               1.      1.      1.
GRID    8               0.      1.      1.
CHEXA   1       7       1       2       3       4       5       6       +A
+A      7       8
PSOLID  7       3
MAT1    3       2.1+11          .3      7850.
PLOAD4  5       1       1.0                             1       3
ENDDATA
)";

  std::string
  changed(std::string text, const std::string &old, const std::string &by)
  {
    const auto at = text.find(old);
    if (at == std::string::npos)
      check(false, "the test changes '" + old + "'");
    return text.replace(at, old.size(), by);
  }

  void
  refuses(const std::string              &text,
          const Shape                     shape,
          const std::string              &part,
          const std::string              &what,
          const std::string              &volume = "",
          const std::vector<std::string> &faces  = {})
  {
    check_throws<InputError>(
      [&]() {
        try
          {
            mesh_of(text, shape, volume, faces);
          }
        catch (const InputError &e)
          {
            check(std::string(e.what()).find('\n') == std::string::npos &&
                    std::string(e.what()).find("in.") != std::string::npos,
                  "one line that names the file");
            throw;
          }
      },
      part,
      "refused: " + what);
  }

  void
  abaqus()
  {
    check(mesh_of(inp, Shape::abaqus, "I", {"I.top", "I.floor"}).cells.size() ==
            1,
          "the file that is spoilt below");
    const auto spoilt = [&](const std::string &old,
                            const std::string &by,
                            const std::string &part) {
      refuses(changed(inp, old, by), Shape::abaqus, part, old + " -> " + by);
    };
    refuses("", Shape::abaqus, "empty", "an empty file");
    refuses("1, 2, 3\n", Shape::abaqus, "no keywords", "another format");
    refuses(inp.substr(0, inp.size() - 1),
            Shape::abaqus,
            "truncated",
            "a last line without its end");
    refuses(inp.substr(0, inp.find("*End Step")),
            Shape::abaqus,
            "*STEP of line 30",
            "a step without end");
    refuses(inp.substr(0, inp.find("*End Assembly")),
            Shape::abaqus,
            "*ASSEMBLY",
            "an assembly without end");
    refuses(inp.substr(0, inp.find("*Assembly")),
            Shape::abaqus,
            "its parts need an *ASSEMBLY",
            "parts without instances");
    for (const auto &[keyword, full] : {std::pair("*SYS", "*SYSTEM"),
                                        std::pair("*INCL, INPUT=a", "*INCLUDE"),
                                        std::pair("*NGE", "*NGEN")})
      spoilt("*Node",
             std::string(keyword) + "\n*Node",
             std::string(full) + " is not read");
    spoilt("1., 0., 0.\n*End Instance",
           "0., 0., 0., 0., 0., 1., 90.\n*End Instance",
           "a translation has 3 numbers; a rotation stands in the line behind");
    spoilt("1., 0., 0.\n*End Instance",
           "1., 0., 0.\n0., 0., 0., 0., 0., 1., 90.\n1.,\n*End Instance",
           "an instance has a translation and a rotation, no third line");
    spoilt("*Node", "*MAT\n*Node", "*MAT may be short for *");
    spoilt("*Surface", "*SURF", "SURFACE: spell it out");
    spoilt("*Part", "*ENDPART\n*Part", "*END PART without *PART");
    spoilt("2, 1, 0, 0", "1, 1, 0, 0", "in.inp:4: node 1 is there twice");
    spoilt("2, 1, 0, 0", "2, 1, x, 0", "'x' is not a number");
    spoilt("2, 1, 0, 0", "2, 1, nan, 0", "not finite");
    spoilt("1, 1, 2, 3, 4, 5, 6, 7, 8\n",
           "1, 1, 2, 3, 4, 5, 6, 7, 9\n",
           "node 9, which is not in the file");
    spoilt(", 7, 8\n*Elset", ", 7\n*Elset", "7 nodes instead of 8");
    spoilt(", 7, 8\n*Elset", ", 7, 8, 8\n*Elset", "9 nodes instead of 8");
    spoilt("*Node\n", "*Node, system=C\n", "SYSTEM=C is not read");
    spoilt("*Node\n", "*Include, input=nodes.inp\n*Node\n", "*INCLUDE");
    spoilt("*Node\n", "*Node, input=nodes.inp\n", "INPUT=");
    spoilt("*Node\n", "*Imperfection\n1, .1\n*Node\n", "write the moved");
    spoilt("4, 5, 6, 7, 8\n*Elset",
           "4, 5, 6, 7, 8\n9, 2, 3, 4, 1, 6, 7, 8, 5\n*Elset, elset=both\n9,\n"
           "*Elset",
           "elements 1 and 9 have the same corners");
    spoilt("*End Part",
           "*Solid section, elset=b, material=M\n*End Part",
           "in.inp:19: there is no set of elements 'b'");
    spoilt("*Node\n", "*Ngen\n1, 2, 1\n*Node\n", "*NGEN is not read");
    spoilt("type=C3D8", "", "*ELEMENT needs TYPE");
    spoilt("type=C3D8\n1, 1, 2, 3, 4,",
           "type=C3D10\n1, 1, 2, 3, 4,",
           "tetrahedra (1)");
    spoilt("type=C3D8", "type=COH3D8", "cells of an unknown kind (1)");
    spoilt("all, S2", "all, S7", "S1 to S6, not 'S7'");
    spoilt("all, S2", "some, S2", "no set of elements 'some'");
    spoilt("1, 4, 1", "11, 14, 1", "nothing in the file");
    spoilt("1, 4, 1", "1, 4, 0", "increment of at least 1");
    spoilt("elset=all\n1,", "elset=all\n2,", "element 2 is not there");
    spoilt("part=Cube", "part=Ball", "no part 'Ball'");
    spoilt("1., 0., 0.", "1., 0., 0.\n0, 0, 0, 0, 0, 0, 90", "are the same");
    spoilt("1., 0., 0.", "1., 0., 0.\n0, 0, 90", "7 numbers");
    spoilt("*Material, name=M\n", "", "without *MATERIAL");
    refuses(
      inp, Shape::abaqus, "element set 'X'; there are: I, I.all", "X", "X");
    refuses(inp,
            Shape::abaqus,
            "no surface or set 'I.bottom'",
            "a surface that is not there",
            "",
            {"I.bottom"});
    refuses(changed(inp, "*End Part", "*Surface, name=lid\nall, S2\n*End Part"),
            Shape::abaqus,
            "say with 'Mesh faces'",
            "a face in two surfaces");
  }

  void
  nastran()
  {
    check(mesh_of(bdf, Shape::nastran, "7", {"load 5"}).cells.size() == 1,
          "the file that is spoilt below");
    const auto spoilt = [&](const std::string &old,
                            const std::string &by,
                            const std::string &part) {
      refuses(changed(bdf, old, by), Shape::nastran, part, old + " -> " + by);
    };
    refuses("", Shape::nastran, "empty", "an empty file");
    refuses("SOL 103\nCEND\n", Shape::nastran, "no GRID", "no bulk data");
    refuses(bdf.substr(0, bdf.find("ENDDATA")),
            Shape::nastran,
            "truncated",
            "a file without ENDDATA");
    spoilt("GRID    2       ", "GRID    1       ", "in.bdf:3: grid point 1");
    spoilt("GRID    2       ", "GRID    2       6", "coordinate system 6");
    spoilt("GRID    2               1.",
           "GRID    2               x.",
           "not a finite number");
    spoilt("+A      7       8", "+A      7       9", "grid point 9");
    spoilt("+A      7       8", "+B      7       8", "sort the lines");
    spoilt("+A      7       8", "+A      7", "grid point 0");
    spoilt("GRID    1", "+       1\nGRID    1", "continues nothing");
    spoilt("CHEXA   1  ", "CHEXA   x  ", "'x' is not an integer");
    spoilt("CHEXA   1  ", "CTETRA  1  ", "tetrahedra (1)");
    spoilt("1       3\nEND", "1       2\nEND", "no opposite corners");
    spoilt("PLOAD4  5       1", "PLOAD4  5       2", "element 2");
    spoilt("ENDDATA", "INCLUDE 'a.bdf'\nENDDATA", "INCLUDE");
    spoilt("BEGIN BULK", "INCLUDE 'a.bdf'\nBEGIN BULK", "in.bdf:1: INCLUDE");
    spoilt("GRID    3", "=,*(1),=,*(1.),==\nGRID    3", "replication");
    spoilt("GRID    3", "=(2)\nGRID    3", "write the entries out");
    spoilt("GRID    3", "=       *(1)    =\nGRID    3", "replication");
    spoilt("ENDDATA",
           "CHEXA,2,7,1,2,3,4,5,6\n,7,8\nENDDATA",
           "elements 1 and 2 have the same corners");
    spoilt(
      "PSOLID  7       3", "PSOLID,7,3,,,,,PFLUID", "cells of a fluid (1)");
    spoilt("ENDDATA", "MAT9,3,1.+11\nENDDATA", "material 3 is there twice");
    spoilt("BEGIN BULK",
           "PARAM,WTMASS,.25\nBEGIN BULK\nPARAM,WTMASS,.5",
           "in.bdf:3: PARAM,WTMASS has another value above");
    spoilt("ENDDATA", "BEGIN SUPER=1\nENDDATA", "BEGIN SUPER");
    spoilt("ENDDATA", "BEGIN BULK SUPER=1\nENDDATA", "BEGIN SUPER");
    spoilt("BEGIN BULK", "BEGIN BULK SUPER=1", "in.bdf:1: parts of a model");
    spoilt("BEGIN BULK", "BEGIN SUPER=1", "in.bdf:1: parts of a model");
    spoilt("ENDDATA", "GRDSET,,4\nENDDATA", "GRDSET");
    spoilt("ENDDATA", "PARAM,WTMASS,0.\nENDDATA", "WTMASS must be positive");
    spoilt("ENDDATA", "MAT1,3,1.,,.3,1.\nENDDATA", "material 3 is there twice");
    refuses(bdf, Shape::nastran, "property or set '8'; there are: 7", "8", "8");
  }

  void
  materials()
  {
    const auto refuses_material =
      [](const std::string &text, const Shape shape, const std::string &part) {
        SceneParameters scene;
        scene.bodies.resize(1);
        scene.bodies[0].name                    = "b";
        scene.bodies[0].shape                   = shape;
        scene.bodies[0].mesh_file               = "in.material";
        scene.bodies[0].material_from_mesh_file = true;
        std::ofstream("in.material") << text;
        check_throws<InputError>(
          [&]() { take_mesh_materials(scene); }, part, "refused: " + part);
      };
    const std::string whole = changed(
      inp, "*End Part", "*Solid Section, elset=all, material=m\n*End Part");
    refuses_material(inp, Shape::abaqus, "no material");
    refuses_material(changed(whole, "2e11, .3", "2e11, .3\n1e11, .3, 500."),
                     Shape::abaqus,
                     "depends on temperature");
    refuses_material(changed(whole, "*Elastic\n", "*Elastic, type=ORTHO\n"),
                     Shape::abaqus,
                     "not isotropic");
    refuses_material(changed(whole, "material=m", "material=m, orientation=o"),
                     Shape::abaqus,
                     "axes of its own");
    refuses_material(changed(whole, "7800.,", "0.,"), Shape::abaqus, "rho 0");
    refuses_material(changed(bdf, "7850.", ""), Shape::nastran, "rho 0");
    refuses_material(changed(bdf, "ENDDATA", "MATT1,3,5\nENDDATA"),
                     Shape::nastran,
                     "depends on temperature");
    refuses_material(
      changed(whole, "*Density", "*Viscoelastic, frequency=TABULAR\n*Density"),
      Shape::abaqus,
      "depends on frequency");
    refuses_material(changed(bdf, "ENDDATA", "MATF1,3,5\nENDDATA"),
                     Shape::nastran,
                     "depends on frequency");
    for (const auto &[entry, fault] :
         {std::pair("MAT9", "not isotropic (MAT9)"),
          std::pair("MAT10", "a fluid"),
          std::pair("MAT11", "not isotropic (MAT11)"),
          std::pair("MAT12", "not isotropic (MAT12)"),
          std::pair("MATHP", "hyperelastic")})
      refuses_material(changed(bdf, "MAT1    3", std::string(entry) + ",3,"),
                       Shape::nastran,
                       fault);
    refuses_material(
      changed(bdf, "PSOLID  7", "PSOLID  8"), Shape::nastran, "no material");
  }

  /** A damaged file is refused or is a smaller mesh: nothing else happens. */
  void
  cut_anywhere()
  {
    unsigned int n_refused = 0, n_cuts = 0;
    for (const auto &[text, shape] :
         {std::pair(inp, Shape::abaqus), std::pair(bdf, Shape::nastran)})
      for (std::size_t n = 1; n < text.size(); ++n)
        for (const std::string &middle : {std::string(), std::string(",*1\n")})
          try
            {
              ++n_cuts;
              mesh_of(text.substr(0, n) + middle +
                        (middle.empty() ? "" : text.substr(n)),
                      shape);
            }
          catch (const InputError &e)
            {
              ++n_refused;
              if (std::string(e.what()).find('\n') != std::string::npos)
                check(false, std::string("one line: ") + e.what());
            }
    check(n_refused > n_cuts / 2, "most damage is seen");
    for (std::size_t n = 1; n + 9 < bdf.size(); ++n)
      if (bool refused = false; true)
        {
          try
            {
              mesh_of(bdf.substr(0, n), Shape::nastran);
            }
          catch (const InputError &)
            {
              refused = true;
            }
          if (!refused)
            check(false, "refused: bulk data cut after " + std::to_string(n));
        }
  }
} // namespace



int
main()
{
  abaqus();
  nastran();
  materials();
  cut_anywhere();
}
