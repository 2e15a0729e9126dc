// SPDX-License-Identifier: LGPL-2.1-or-later

// A body may consist of parts that share no nodes where something holds each of
// them; a part that nothing holds is refused by its place. A slit in a body
// that hangs together, where nodes are doubled, is told.

#include <squeal/base/exceptions.h>

#include "gmsh_cube.h"

using namespace squeal;
using namespace squeal::testing;

namespace
{
  /** The cube in two halves; the upper one has nodes of its own, @p gap up. */
  std::string
  halves(const double gap = .1)
  {
    const Cube         cube;
    std::ostringstream out;
    out << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n" << names << "$Nodes\n54\n";
    for (int n = 0; n < 54; ++n)
      {
        auto x = cube.nodes[n % 27];
        x[2] += n < 27 ? 0. : gap;
        out << n + 1 << spaced(x) << "\n";
      }
    out << "$EndNodes\n$Elements\n12\n";
    int tag = 1;
    for (auto quad : Cube::plane(0, 0))
      {
        bool upper = false;
        for (const int node : quad)
          upper = upper || node > 18;
        for (int &node : quad)
          node += upper ? 27 : 0;
        out << tag++ << " 3 2 1 7" << spaced(quad) << "\n";
      }
    for (int c = 0; c < 8; ++c)
      {
        auto cell = cube.cells[c];
        for (int &node : cell)
          node += c < 4 ? 0 : 27;
        out << tag++ << " 5 2 0 1" << spaced(cell) << "\n";
      }
    out << "$EndElements\n";
    return out.str();
  }

  SceneParameters
  scene_of_halves()
  {
    std::ofstream("halves.msh") << halves();
    SceneParameters scene;
    BodyParameters  body;
    body.name      = "vanes";
    body.shape     = BodyParameters::Shape::gmsh;
    body.mesh_file = "halves.msh";
    scene.bodies   = {body};
    return scene;
  }

  /** Beside the face "left" (x = 0), as high as given. */
  void
  add_wall(SceneParameters &scene, const double height)
  {
    BodyParameters wall;
    wall.name     = "wall";
    wall.size     = {{.2, 2., height}};
    wall.position = {{-.1, .5, 0.}};
    wall.cells    = {{1, 1, 1}};
    scene.bodies.push_back(wall);
    TieParameters tie;
    tie.name        = "root";
    tie.source_body = "vanes";
    tie.source_face = "left";
    tie.target_body = "wall";
    tie.target_face = "x_max";
    scene.ties      = {tie};
  }

  /** The cube with nodes of their own, @p gap above the others, for the two
   * cells above the middle plane at x = 1: half of that plane is slit, open at
   * x = 1, and the body still hangs together. */
  std::string
  slit(const double gap)
  {
    const Cube  cube;
    std::string text = replaced(version_2(cube), "$Nodes\n27", "$Nodes\n30");
    std::string nodes;
    for (int i = 0; i < 3; ++i)
      {
        auto x = cube.nodes[11 + 3 * i];
        x[2] += gap;
        nodes += std::to_string(28 + i) + spaced(x) + "\n";
      }
    text = replaced(text, "$EndNodes", nodes + "$EndNodes");
    for (const int c : {5, 7})
      {
        auto cell = cube.cells[c];
        for (int &node : cell)
          if (node == 12 || node == 15 || node == 18)
            node = 28 + (node - 12) / 3;
        text = replaced(text, spaced(cube.cells[c]), spaced(cell));
      }
    return text;
  }

  void
  test_slits()
  {
    SceneParameters scene   = scene_of_halves();
    const auto      remarks = [&](const std::string &text) {
      std::ofstream("halves.msh") << text;
      return make_coarse_mesh(scene).remarks;
    };
    check(remarks(version_2(Cube())).empty(), "no word of a whole body");
    const auto told = remarks(slit(0.));
    check(told.size() == 1 &&
            told[0].find("2 pairs of faces that lie on each other") !=
              std::string::npos &&
            told[0].find("at (0.750000, 0.250000, 0.500000) m") !=
              std::string::npos,
          "a slit is told with its place: " + (told.empty() ? "" : told[0]));
    check(remarks(slit(1e-3)).empty(), "a gap that is meant is not");
  }

  /** Two parts of one body that lie on each other and are put together by a
   * contact of their own faces are no slit. */
  void
  test_parts_in_contact()
  {
    SceneParameters scene = scene_of_halves();
    std::ofstream("halves.msh") << halves(0.);
    add_wall(scene, 1.1);
    const auto open = make_coarse_mesh(scene).remarks;
    check(open.size() == 1 && open[0].find("4 pairs") != std::string::npos,
          "parts that lie on each other with nothing between are told");
    ContactParameters contact;
    contact.source_body = contact.target_body = "vanes";
    contact.source_face = contact.target_face = "unnamed";
    scene.contacts                            = {contact};
    check(make_coarse_mesh(scene).remarks.empty(), "not so across a contact");
  }
} // namespace

int
main()
{
  SceneParameters scene = scene_of_halves();
  check_throws<InputError>([&]() { make_coarse_mesh(scene); },
                           "2 parts that share no nodes, and nothing holds the "
                           "part of 4 cells",
                           "refused: two parts that nothing holds");
  SupportParameters support;
  support.name   = "clamp";
  support.body   = "vanes";
  support.face   = "left";
  scene.supports = {support};
  check(make_coarse_mesh(scene).cells.size() == 8, "a support holds both");
  scene.supports[0].kind = SupportParameters::Kind::free;
  check_throws<InputError>([&]() { make_coarse_mesh(scene); },
                           "nothing holds",
                           "refused: a support that holds nothing");
  scene = scene_of_halves();
  add_wall(scene, 1.1);
  check(make_coarse_mesh(scene).cells.size() == 9, "a tie holds both");
  scene = scene_of_halves();
  add_wall(scene, .4);
  check_throws<InputError>([&]() { make_coarse_mesh(scene); },
                           "nothing holds",
                           "refused: a part that the tied body does not reach");
  test_slits();
  test_parts_in_contact();
}
