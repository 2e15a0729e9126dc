// SPDX-License-Identifier: LGPL-2.1-or-later

// A tie joins two faces only if their meshes are the same: corners alone do not
// tell the quads between them, nor where cells of second order bulge.

#include <squeal/scene/matching_faces.h>

#include <cmath>

#include "../check.h"

using namespace squeal;
using namespace squeal::testing;
using dealii::Point;

namespace
{
  constexpr unsigned int source = 5, target = 6;

  void
  add_quad(CoarseMesh                        &mesh,
           const unsigned int                 id,
           const std::array<unsigned int, 4> &corners)
  {
    mesh.boundary.boundary_quads.emplace_back();
    auto &quad       = mesh.boundary.boundary_quads.back();
    quad.boundary_id = id;
    quad.vertices.assign(corners.begin(), corners.end());
  }

  /** Two cubes on each other, the corners of both in any order. */
  CoarseMesh
  two_cubes()
  {
    CoarseMesh mesh;
    for (unsigned int c = 0; c < 2; ++c)
      {
        mesh.cells.emplace_back();
        mesh.cells.back().vertices.resize(8);
        for (unsigned int v = 0; v < 8; ++v)
          {
            mesh.cells.back().vertices[v] = mesh.vertices.size();
            mesh.vertices.push_back(
              Point<3>(v % 2, v / 2 % 2, v / 4 + (c == 0 ? 0. : 1.)));
          }
      }
    add_quad(mesh, source, {{4, 5, 6, 7}});
    add_quad(mesh, target, {{9, 11, 8, 10}});
    return mesh;
  }

  /** The cube's nodes of second order, those at z = @p plane raised in the middle
   * of the edge at y = 0 and of the face. */
  CellNodes
  bulging(const double bottom, const double plane, const double height)
  {
    CellNodes nodes;
    for (unsigned int n = 0; n < 27; ++n)
      {
        nodes[n] =
          Point<3>(.5 * (n % 3), .5 * (n / 3 % 3), bottom + .5 * (n / 9));
        if (nodes[n][2] == plane && n % 3 == 1 && n / 3 % 3 < 2)
          nodes[n][2] += height;
      }
    return nodes;
  }

  void
  nodes_between_corners()
  {
    CoarseMesh mesh = two_cubes();
    const auto size = [&mesh] {
      return matching_vertices(mesh, source, target).size();
    };
    check(size() == 4 && matching_vertices(mesh, source, target).at(5) == 9,
          "straight cells with the same corners");
    mesh.curved[1] = bulging(1., 1., 0.);
    check(size() == 4, "nodes that are where the corners have them");
    mesh.curved[1] = bulging(1., 1., .01);
    check(size() == 0, "a curved face on a straight one");
    mesh.curved[0] = bulging(0., 1., .01);
    check(size() == 4, "both curved alike");
    mesh.curved[0] = bulging(0., 1., .02);
    check(size() == 0, "both curved, not alike");
    mesh.curved.erase(1);
    check(size() == 0, "a straight face on a curved one");
  }

  void
  quads_between_corners()
  {
    CoarseMesh mesh;
    for (unsigned int body = 0; body < 2; ++body)
      for (unsigned int v = 0; v < 6; ++v)
        mesh.vertices.push_back(
          Point<3>(std::cos(v * M_PI / 3.), std::sin(v * M_PI / 3.), 0.));
    CoarseMesh other = mesh;
    for (CoarseMesh *m : {&mesh, &other})
      {
        add_quad(*m, source, {{0, 1, 3, 2}});
        add_quad(*m, source, {{0, 3, 5, 4}});
      }
    add_quad(mesh, target, {{6, 7, 9, 8}});
    add_quad(mesh, target, {{6, 9, 11, 10}});
    add_quad(other, target, {{7, 8, 10, 9}});
    add_quad(other, target, {{7, 10, 6, 11}});
    check(matching_vertices(mesh, source, target).size() == 6,
          "a hexagon that is cut alike");
    check(matching_vertices(other, source, target).empty(),
          "and one that is cut across another diagonal");
  }
} // namespace

int
main()
{
  nodes_between_corners();
  quads_between_corners();
}
