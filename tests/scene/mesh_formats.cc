// SPDX-License-Identifier: LGPL-2.1-or-later

// An annulus of 8, 20 and 27 nodes a cell is the same body from a file of
// Gmsh, Abaqus and Nastran in each of its field formats; sets, surfaces,
// instances, skins and loads name the faces that they are meant to name.

#include <squeal/base/exceptions.h>
#include <squeal/scene/mesh_materials.h>

#include "gmsh_annulus.h"
#include "mesh_texts.h"
#include "worst.h"

using namespace squeal;
using namespace squeal::testing;

namespace
{
  using Shape = BodyParameters::Shape;

  MeshFile
  annulus(const unsigned int n_nodes)
  {
    BodyParameters body;
    body.inner_radius = .1;
    body.outer_radius = .2;
    body.height       = .03;
    body.cells        = {{6, 2, 1}};
    AnnulusFile(body, n_nodes).write_2("annulus.msh");
    return read_gmsh_file("annulus.msh");
  }

  BodyMesh
  from_gmsh()
  {
    BodyParameters body;
    body.name      = "disc";
    body.shape     = Shape::gmsh;
    body.mesh_file = "annulus.msh";
    return read_mesh_body(body);
  }

  /** Names of faces by the sorted corners. */
  std::map<std::vector<unsigned int>, std::string>
  faces_of(const BodyMesh &mesh)
  {
    std::map<std::vector<unsigned int>, std::string> result;
    for (const auto &quad : mesh.boundary)
      {
        std::vector<unsigned int> key(quad.vertices.begin(),
                                      quad.vertices.end());
        std::sort(key.begin(), key.end());
        result[key] = mesh.face_names[quad.boundary_id];
      }
    return result;
  }

  void
  check_same(const BodyMesh    &mesh,
             const BodyMesh    &expected,
             const double       tolerance,
             const bool         same_names,
             const std::string &what)
  {
    check(mesh.cells.size() == expected.cells.size() &&
            mesh.vertices.size() == expected.vertices.size() &&
            mesh.curved.size() == expected.curved.size(),
          what + ": cells, vertices, curved cells");
    Worst distance;
    for (unsigned int v = 0; v < mesh.vertices.size(); ++v)
      distance.add(mesh.vertices[v].distance(expected.vertices[v]));
    for (unsigned int c = 0; c < mesh.cells.size(); ++c)
      check(mesh.cells[c].vertices == expected.cells[c].vertices,
            what + ": corners of cell " + std::to_string(c));
    for (const auto &[cell, nodes] : expected.curved)
      for (unsigned int i = 0; i < 27; ++i)
        distance.add(mesh.curved.at(cell)[i].distance(nodes[i]));
    check(distance.largest() <= tolerance, what + ": points");
    if (same_names)
      check(faces_of(mesh) == faces_of(expected), what + ": faces");
  }

  void
  same_body_from_every_format()
  {
    for (const unsigned int n : {8, 20, 27})
      {
        const MeshFile    file     = annulus(n);
        const BodyMesh    expected = from_gmsh();
        const std::string nodes    = std::to_string(n) + " nodes, ";
        check(expected.curved.size() == (n == 8 ? 0 : 12), "curved cells");
        check_same(mesh_of(abaqus_text(file), Shape::abaqus),
                   expected,
                   1e-16,
                   true,
                   nodes + "Abaqus");
        if (n == 27)
          continue;
        for (const auto &[format, tolerance] : {std::pair(Format::large, 1e-13),
                                                std::pair(Format::free, 1e-13),
                                                std::pair(Format::small, 2e-6)})
          {
            const BodyMesh mesh =
              mesh_of(nastran_text(file, format), Shape::nastran, "9");
            check_same(mesh,
                       expected,
                       tolerance,
                       false,
                       nodes + "Nastran " +
                         std::to_string(static_cast<int>(format)));
            auto names = faces_of(mesh);
            for (auto &[corners, name] : names)
              name = file.surface_names.at(std::stoi(name));
            check(names == faces_of(expected), nodes + "faces are skins");
          }
      }
  }



  const std::string two_cells = R"(*HEADING
two cells on top of each other
*NODE, NSET=all
1, 0, 0, 0
2, 1, 0, 0
3, 1, 1, 0
4, 0, 1, 0
5, 0, 0, 1
6, 1, 0, 1
7, 1, 1, 1
8, 0, 1, 1
9, 0, 0, 2
10, 1, 0, 2
11, 1, 1, 2
12, 0, 1, 2
*ELEMENT, TYPE=C3D8I, ELSET=low
10, 1, 2, 3, 4, 5, 6, 7, 8
*ELEMENT, TYPE=C3D8R, ELSET=high
20, 5, 6, 7, 8, 9, 10, 11, 12
*NSET, NSET=floor, GENERATE
1, 4, 1
*NSET, NSET="roof"
 9, 10, 11,
 12
*ELSET, ELSET=both
low, high
*SURFACE, NAME=skin
both,
*SURFACE, NAME=Side
both, S4
*SURFACE, NAME=points, TYPE=NODE
roof,
*MATERIAL, NAME=Steel
*DENSITY
7.85e-9,
*ELASTIC
210000., .3
*SOLID SECTION, ELSET=both, MATERIAL=STEEL
,
*STEP
*FREQUENCY
10,
*END STEP
)";

  std::string
  replaced_word(std::string text, const std::string &old, const std::string &by)
  {
    const auto at = text.find(old);
    check(at != std::string::npos, "the test changes '" + old + "'");
    return text.replace(at, old.size(), by);
  }

  /** Number of the body's faces of each name. */
  std::map<std::string, unsigned int>
  count(const BodyMesh &mesh)
  {
    std::map<std::string, unsigned int> result;
    for (const auto &[corners, name] : faces_of(mesh))
      ++result[name];
    return result;
  }

  using Count = std::map<std::string, unsigned int>;

  void
  abaqus_sets()
  {
    check(count(mesh_of(two_cells, Shape::abaqus, "", {"skin"})) ==
            Count{{"skin", 10}},
          "a surface without S1 to S6 is all that is free");
    check(count(mesh_of(
            two_cells, Shape::abaqus, "", {"side", "FLOOR", "points"})) ==
            Count{{"side", 2}, {"FLOOR", 1}, {"points", 1}, {"unnamed", 6}},
          "surfaces and sets of nodes, in the letters that the user writes");
    check(count(mesh_of(two_cells, Shape::abaqus, "high", {"roof"})) ==
            Count{{"roof", 1}, {"unnamed", 5}},
          "an element set is a body");
    check(
      mesh_of(two_cells, Shape::abaqus, "low", {"floor"}).touching_volumes ==
        std::vector<std::string>{"both", "high"},
      "its neighbours are known");

    const std::string instances =
      "*Part, name=Cube\n" +
      two_cells.substr(two_cells.find("*NODE"),
                       two_cells.find("*MATERIAL") - two_cells.find("*NODE")) +
      R"(*End Part
*Assembly, name=Assembly
*Instance, name=Cube-1, part=Cube
*End Instance
*Instance, name=Cube-2, part=Cube
 10., 0., 0.
 10., 0., 0., 10., 0., 1., 90.
*End Instance
*Nset, nset=tip, instance=Cube-2
 9, 10, 11, 12
*Elset, elset=one, instance=Cube-2
 10,
*Surface, name=mixed
Cube-2.low, S1
Cube-1.20, S2
*End Assembly
)";
    const BodyMesh second = mesh_of(
      instances, Shape::abaqus, "Cube-2", {"tip", "Cube-2.Side", "mixed"});
    check(count(second) ==
            Count{{"tip", 1}, {"Cube-2.Side", 2}, {"mixed", 1}, {"unnamed", 6}},
          "names of an instance");
    for (const auto &[corners, name] : faces_of(second))
      for (const unsigned int v : corners)
        {
          const auto &x = second.vertices[v];
          check(x[0] > 8.9 && x[0] < 10.1 && x[1] > -.1 && x[1] < 1.1,
                "an instance is shifted, then turned by the right hand");
          // x = 1 of the part is y = 1 of the instance
          if (name == "Cube-2.Side")
            check(std::abs(x[1] - 1.) < 1e-14, "and so are its faces");
        }
    check(mesh_of(instances, Shape::abaqus, "one", {"mixed"}).cells.size() == 1,
          "a set of the assembly names elements of an instance");
  }



  const std::string bulk = R"(BEGIN BULK
GRID    1               0.      0.      0.
GRID    2               1.      0.      0.
GRID    3               1.      1.      0.
GRID    4               0.      1.      0.
GRID    5               0.      0.      1.
GRID    6               1.      0.      1.
GRID    7               1.      1.      1.
GRID    8               0.      1.      1.
GRID,21,,.5,0.,-.05
CHEXA   1       7       1       2       3       4       5       6       +A
+A      7       8       21
PSOLID  7       3
MAT1*   3               2.1+5                           .3
*       7.85-9
PLOAD4  5       1       1.0                             1       3
SET1,11,5,THRU,8
SET3,12,ELEM,1
RBE2,99,1,123,2,3
ENDDATA
)";

  void
  nastran_entries()
  {
    const BodyMesh mesh =
      mesh_of(bulk, Shape::nastran, "set 12", {"load 5", "set 11"});
    check(count(mesh) == Count{{"load 5", 1}, {"set 11", 1}, {"unnamed", 4}},
          "loads and sets of points name faces");
    check(mesh.curved.size() == 1, "one middle point makes a curved cell");
    check_close(mesh.curved.at(0)[1][2], -.05, 1e-15, "the point given");
    check_close(mesh.curved.at(0)[3].distance({0., .5, 0.}) + 1.,
                1.,
                1e-15,
                "an edge without its point is straight");
    check(mesh.remarks.size() == 2 &&
            mesh.remarks[0].find("RBE2") != std::string::npos,
          "what is not followed is said");
    check(mesh.remarks[1].find("E 210000 Pa, nu 0.3") != std::string::npos,
          "another material is said");
  }



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
    std::ofstream("steel.bdf") << bulk;
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
    check_close(read_mesh_body(scene.bodies[0]).vertices.back()[2],
                .002,
                1e-15,
                "lengths in m");
    scene.bodies[0].density *= 1.001;
    check(read_mesh_body(scene.bodies[0]).remarks.at(0).find("'Steel'") !=
            std::string::npos,
          "a disagreement is said");
  }

  /** Densities that are weights over g, and damping, which is the scene's. */
  void
  factors_of_materials()
  {
    std::string text = bulk;
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
                        "*Modal damping\n1, 10, .01\n"),
          Shape::abaqus,
          {"skin"},
          {"*NONSTRUCTURAL MASS",
           "*FOUNDATION",
           "*INITIAL CONDITIONS",
           "*ROTARY INERTIA",
           "*BOUNDARY",
           "*MODAL DAMPING"});
    const std::string text = replaced_word(bulk,
                                           "ENDDATA",
                                           "SPC1,1,123456,1,THRU,4\n"
                                           "SPCADD,2,1\n"
                                           "PARAM,G,0.05\n"
                                           "PARAM,ALPHA1,0.\n"
                                           "CMASS2,31,1.,1,1\n"
                                           "CDAMP2,33,5.,1,1\n"
                                           "NSM1,4,PSOLID,.5,7\n"
                                           "TEMPD,1,300.\n"
                                           "ENDDATA");
    names(text,
          Shape::nastran,
          {},
          {"SPC1", "SPCADD", "PARAM,G", "CMASS2", "CDAMP2", "NSM1", "TEMPD"});
    check(mesh_of(text, Shape::nastran).remarks[0].find("ALPHA1") ==
            std::string::npos,
          "damping of 0 is none");
  }

  void
  ties_of_files()
  {
    SceneParameters scene;
    std::ofstream("tied.inp")
      << two_cells.substr(0, two_cells.find("*STEP"))
      << "*SURFACE, NAME=under\nhigh, S1\n*SURFACE, NAME=over\nlow, S2\n"
         "*TIE, NAME=glue\nUNDER, OVER\n";
    for (const std::string name : {"low", "high"})
      {
        BodyParameters body;
        body.name = body.physical_volume = name;
        body.shape                       = Shape::abaqus;
        body.mesh_file                   = "tied.inp";
        body.mesh_faces                  = {name == "low" ? "over" : "under"};
        scene.bodies.push_back(body);
      }
    TieParameters tie;
    tie.source_body = "low";
    tie.source_face = "over";
    tie.target_body = "high";
    tie.target_face = "under";
    scene.ties      = {tie};
    check(make_coarse_mesh(scene).vertices.size() == 12, "a tie of the scene");
    scene.ties.clear();
    ContactParameters contact;
    contact.source_body = "high";
    contact.source_face = "under";
    contact.target_body = "low";
    contact.target_face = "under";
    scene.contacts      = {contact};
    check_throws<InputError>([&]() { make_coarse_mesh(scene); },
                             "ties 'UNDER' to 'OVER' (glue)",
                             "refused: a tie that the scene leaves out");
  }
} // namespace



int
main()
{
  same_body_from_every_format();
  abaqus_sets();
  nastran_entries();
  materials_of_files();
  factors_of_materials();
  what_is_not_followed();
  ties_of_files();
}
