// SPDX-License-Identifier: LGPL-2.1-or-later

// Gmsh files that cannot be used are refused in one line that names the file
// and says what to do.

#include <squeal/base/exceptions.h>
#include <squeal/scene/check_meshes.h>

#include "gmsh_cube.h"

#include <algorithm>
#include <filesystem>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  void
  refuses(const std::string &text,
          const std::string &part,
          const std::string &what,
          const std::string &volume = "")
  {
    check_throws<InputError>(
      [&]() {
        try
          {
            read(text, volume);
          }
        catch (const InputError &e)
          {
            check(std::string(e.what()).find('\n') == std::string::npos &&
                    std::string(e.what()).find("mesh.msh") != std::string::npos,
                  "one line that names the file");
            throw;
          }
      },
      part,
      "refused: " + what);
  }

  void
  unreadable_files()
  {
    const std::string two = version_2(Cube()), four = version_4(Cube());
    BodyParameters    body;
    body.name               = "pad";
    body.shape              = BodyParameters::Shape::gmsh;
    const auto refuses_file = [&](const std::string &file,
                                  const std::string &part,
                                  const std::string &what) {
      body.mesh_file = file;
      check_throws<InputError>(
        [&]() { read_mesh_body(body); }, part, "refused: " + what);
    };
    refuses_file("", "Scene/Body pad/Mesh file", "no file named");
    refuses_file("nowhere.msh", "nowhere.msh", "a missing file");
    std::filesystem::create_directory("folder.msh");
    refuses_file("folder.msh", "directory", "a directory");

    refuses("", "empty", "an empty file");
    std::string garbage;
    for (unsigned int i = 0, x = 1; i < 5000; ++i)
      garbage += static_cast<char>((x = x * 1664525u + 1013904223u) >> 24);
    refuses(garbage, "not a text file", "binary garbage");
    refuses(
      "solid cube\nfacet normal 0 0 1\n", "no Gmsh mesh", "another format");
    refuses(replaced(two, "2.2 0 8", std::string("2.2 1 8\n\1\0\0\0", 12)),
            "Mesh.Binary = 0",
            "a binary mesh");
    refuses(replaced(two, "2.2 0 8", "4 0 8"), "4.1", "another version");
    refuses(replaced(four, "$Entities", "$PartitionedEntities"),
            "partition",
            "a partitioned mesh");

    // Cut anywhere but before a line end or blank at the very end.
    for (const auto &text : {two, four})
      for (std::size_t n = 40; n + 13 < text.size(); n += 37)
        {
          bool refused = false;
          try
            {
              read(text.substr(0, n));
            }
          catch (const InputError &)
            {
              refused = true;
            }
          if (!refused)
            check(false, "refused: cut after byte " + std::to_string(n));
        }
    refuses(two.substr(0, two.size() / 2), "truncated", "a truncated file");
    refuses(two.substr(0, two.find("$Elements")),
            "truncated",
            "a file without elements");
    refuses(replaced(two, "\n2 0.5 0 0\n", "\n2 0.5 0\n"),
            ":15: expected coordinate",
            "a coordinate too few, by its line");
    refuses(replaced(two, "\n2 0.5 0 0\n", "\n2 0.5 x 0\n"),
            "not a number",
            "text as a coordinate");
    refuses(replaced(two, "\n2 0.5 0 0\n", "\n2 0.5 nan 0\n"),
            "not finite",
            "a coordinate that is not a number");
    refuses(replaced(two, "$Nodes\n27", "$Nodes\n26"),
            "more than it says",
            "more nodes than announced");
    refuses(replaced(two, "$Nodes\n27", "$Nodes\n99999999999"),
            "cannot be right",
            "an absurd number of nodes");
    refuses(replaced(two, "\n2 0.5 0 0\n", "\n1 0.5 0 0\n"),
            "node 1 is there twice",
            "a node number used twice");
    refuses(with_element(Cube(), "5 2 12 1 1 2 3 4 5 6 7 99"),
            "node 99",
            "an unknown node");
  }

  void
  unusable_meshes()
  {
    const Cube        cube;
    const std::string two = version_2(cube), four = version_4(cube);
    refuses(two, "lower, upper", "a volume that does not exist", "pad");
    refuses(two, "lower, upper", "the name of a surface", "left");
    refuses(replaced(two, "3 12 \"upper\"\n", "3 12 \"upper\"\n3 13 \"void\"\n")
              .replace(two.find("Names\n5") + 6, 1, "6"),
            "no cells of physical volume 'void'",
            "an empty physical volume",
            "void");
    // The last cell becomes something else.
    const std::string last = "21 5 2 12 1" + spaced(cube.cells[7]);
    refuses(replaced(two, last, "21 4 2 12 1 14 15 18 17"),
            "tetrahedra (1)",
            "tetrahedra");
    refuses(replaced(two, last, "21 6 2 12 1 14 15 18 23 24 27"),
            "wedges (1)",
            "wedges");
    refuses(replaced(two, last, "21 7 2 12 1 14 15 18 17 23"),
            "pyramids (1)",
            "pyramids");
    refuses(replaced(two, last, "21 92 2 12 1" + spaced(cube.cells[7])),
            "ElementOrder = 2",
            "third-order hexahedra");
    refuses(replaced(two, last, "21 17 2 12 1" + spaced(cube.cells[7])),
            "mesh.msh:64: expected node",
            "a second-order hexahedron without its other nodes");
    refuses(replaced(two, last, last + " 1"),
            "more than the 8 nodes",
            "a hexahedron with more nodes than its type has");
    check(read(replaced(two, last, "21 4 2 12 1 14 15 18 17"), "lower")
              .cells.size() == 4,
          "tetrahedra in another volume do not matter");
    refuses(two.substr(0, two.find("14 5 2 11"))
                .replace(two.find("ts\n21") + 3, 2, "13") +
              "$EndElements\n",
            "three dimensions",
            "a surface mesh");

    Cube bad = cube;
    std::swap_ranges(
      bad.cells[3].begin(), bad.cells[3].begin() + 4, bad.cells[3].begin() + 4);
    refuses(version_4(bad), "first element 17", "one inverted cell");
    bad          = cube;
    bad.nodes[0] = {{.9, .9, .9}};
    refuses(version_2(bad), "folded", "a folded cell");
    bad             = cube;
    bad.cells[0][7] = bad.cells[0][6];
    refuses(version_2(bad), "collapsed", "a collapsed cell");
    // a leaning cell on a face that two cells share already
    std::array<int, 8> leaning = cube.cells[5];
    std::copy_n(cube.cells[4].begin(), 4, leaning.begin());
    refuses(with_element(cube, "5 2 12 1" + spaced(leaning)),
            "overlap",
            "cells that overlap");
    refuses(with_element(cube, "3 2 2 6" + spaced(Cube::plane(0, 0)[0])),
            "a face has one name",
            "a face in two physical surfaces");
  }

  /** A name that is the number of a group without a name. */
  void
  names_that_are_numbers()
  {
    const std::string four_names =
      replaced(version_2(Cube()), "$PhysicalNames\n5", "$PhysicalNames\n4");
    const std::string volumes =
      replaced(replaced(four_names, "3 11 \"lower\"\n", "3 11 \"12\"\n"),
               "3 12 \"upper\"\n",
               "");
    refuses(volumes,
            "a physical volume of the name '12' and another of this number",
            "a volume whose name is the number of another",
            "12");
    check(read(volumes).cells.size() == 8, "both volumes are clear");
    const std::string surfaces =
      replaced(replaced(four_names, "2 1 \"left\"\n", "2 1 \"2\"\n"),
               "2 2 \"right side\"\n",
               "");
    refuses(surfaces,
            "a physical surface of the name '2' and another of this number",
            "a surface whose name is the number of another",
            "lower");
    check(
      read(replaced(four_names, "3 12 \"upper\"\n", ""), "12").cells.size() ==
        4,
      "a number stands for a volume without a name");
  }

  /** Two groups of one name: neither is meant more than the other. */
  void
  names_given_twice()
  {
    const std::string two = version_2(Cube()), four = version_4(Cube());
    for (const auto &text : {two, four})
      {
        const std::string surfaces =
          replaced(text, "2 2 \"right side\"", "2 2 \"left\"");
        refuses(surfaces,
                "a physical surface of the name 'left' twice, with the numbers "
                "1 and 2",
                "two surfaces of one name on the body");
        const std::string volumes =
          replaced(text, "3 12 \"upper\"", "3 12 \"lower\"");
        refuses(volumes,
                "a physical volume of the name 'lower' twice, with the numbers "
                "11 and 12",
                "two volumes of one name",
                "lower");
        check(read(volumes).cells.size() == 8,
              "nothing is asked of names where all volumes make the body");
      }
    // Of the left side the lower half is surface 1, the upper one surface 4.
    std::string apart =
      replaced(two, "$PhysicalNames\n5\n", "$PhysicalNames\n6\n2 4 \"left\"\n");
    for (const std::string element : {"\n3 3 2 ", "\n5 3 2 "})
      apart = replaced(apart, element + "1", element + "4");
    for (const char *half : {"lower", "upper"})
      {
        const auto faces = read(apart, half).face_names;
        check(std::count(faces.begin(), faces.end(), "left") == 1,
              "surfaces of one name on two bodies are a face of each");
      }
  }

  /** Two bodies of one file that share the nodes of the middle plane. */
  void
  shared_nodes()
  {
    std::ofstream("halves.msh") << version_2(Cube());
    SceneParameters scene;
    for (const char *volume : {"lower", "upper"})
      {
        BodyParameters body;
        body.name            = std::string(volume) + " half";
        body.shape           = BodyParameters::Shape::gmsh;
        body.mesh_file       = "halves.msh";
        body.physical_volume = volume;
        scene.bodies.push_back(body);
      }
    check_throws<InputError>([&]() { make_coarse_mesh(scene); },
                             "'lower half' and 'upper half': share nodes",
                             "refused: bodies that share nodes by accident");
    TieParameters tie;
    tie.name        = "middle";
    tie.source_body = "lower half";
    tie.target_body = "upper half";
    tie.source_face = tie.target_face = "middle";
    scene.ties                        = {tie};
    check(make_coarse_mesh(scene).vertices.size() == 27,
          "a tie glues the two halves");
    check_meshes(scene);
    SupportParameters support;
    support.name   = "clamp";
    support.body   = "lower half";
    support.face   = "left";
    scene.supports = {support};
    check_meshes(scene);
    scene.supports[0].face = "wrong";
    check_throws<InputError>([&]() { check_meshes(scene); },
                             "left, right side, middle, unnamed",
                             "refused before a run: a face that is not there");
    std::ofstream("halves.msh") << version_2(Cube()).substr(0, 600);
    check_throws<InputError>([&]() { check_meshes(scene); },
                             "halves.msh",
                             "refused before a run: a truncated mesh");
    std::ofstream("halves.msh") << version_2(Cube());
    scene.bodies.pop_back();
    scene.ties.clear();
    check(make_coarse_mesh(scene).cells.size() == 4,
          "a neighbour that is no body does not matter");
  }
} // namespace

int
main()
{
  shared_nodes();
  unreadable_files();
  unusable_meshes();
  names_that_are_numbers();
  names_given_twice();
}
