// SPDX-License-Identifier: LGPL-2.1-or-later

// An annulus of 8, 20 and 27 nodes a cell is the same body from a file of
// Gmsh, Abaqus and Nastran in each of its field formats; sets, surfaces,
// instances, skins and loads name the faces that they are meant to name.

#include <squeal/base/exceptions.h>

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

  /** Abaqus takes keywords, options and values by their first letters, with or
   * without blanks. */
  void
  abaqus_abbreviations()
  {
    const std::string whole = R"(*Node, nset=all nodes
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
*Element, type=C3D8, elset=cells
1, 1, 2, 3, 4, 5, 6, 7, 8
*Element, type=C3D8, elset=cells
2, 5, 6, 7, 8, 9, 10, 11, 12
*Nset, nset=floor, generate
1, 4, 1
*Elset, elset=both, generate
1, 2, 1
*Surface, name=roof, type=element
2, S2
*Step
*End Step
)";
    std::string       text  = whole;
    for (const auto &[old, by] :
         {std::pair<std::string, std::string>(
            "*Element, type=C3D8, elset=cells\n2",
            "*ELEM, TYP=C3D8, ELS = cells\n2"),
          {"*Nset, nset=floor, generate", "*NSE, NS=floor, GEN"},
          {"elset=both, generate", "elset=both, G E N"},
          {"*Surface, name=roof, type=element",
           "*Sur face, NAM=roof, TYPE=ELEM"},
          {"*End Step", "*ENDSTEP"}})
      {
        const std::size_t at = text.find(old);
        check(at != std::string::npos, "the test changes '" + old + "'");
        text.replace(at, old.size(), by);
      }
    const BodyMesh expected =
      mesh_of(whole, Shape::abaqus, "both", {"floor", "roof"});
    check(expected.cells.size() == 2 &&
            count(expected) == Count{{"floor", 1}, {"roof", 1}, {"unnamed", 8}},
          "two cells, spelled out");
    check_same(mesh_of(text, Shape::abaqus, "both", {"floor", "roof"}),
               expected,
               0.,
               true,
               "abbreviated");
  }

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
    // The same nodes inside the instance, of a part without any.
    const std::string nodes =
      instances.substr(instances.find("*NODE"),
                       instances.find("*End Part") - instances.find("*NODE"));
    const std::string independent =
      "*Part, name=Cube\n*End Part\n*Assembly, name=A\n"
      "*Instance, name=Cube-2, part=Cube\n10., 0., 0.\n"
      "10., 0., 0., 10., 0., 1., 90.\n" +
      nodes + "*End Instance\n*End Assembly\n";
    const BodyMesh meshed =
      mesh_of(independent, Shape::abaqus, "Cube-2", {"Cube-2.Side"});
    check(meshed.vertices == second.vertices,
          "nodes of an instance stand where those of its part would");
    check(mesh_of(instances, Shape::abaqus, "one", {"mixed"}).cells.size() == 1,
          "a set of the assembly names elements of an instance");
  }



  void
  nastran_entries()
  {
    const BodyMesh mesh =
      mesh_of(one_cell, Shape::nastran, "set 12", {"load 5", "set 11"});
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
  abaqus_abbreviations();
  abaqus_sets();
  nastran_entries();
  ties_of_files();
}
