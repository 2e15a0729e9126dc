// SPDX-License-Identifier: LGPL-2.1-or-later

// Hexahedra of second order are read with their curved shape, or refused by
// element where they fold, bulge far or do not fit their neighbours.

#include <squeal/base/exceptions.h>

#include "gmsh_annulus.h"
#include "gmsh_cube.h"

using namespace squeal;
using namespace squeal::testing;

namespace
{
  BodyParameters
  ring()
  {
    BodyParameters body;
    body.name         = "disc";
    body.inner_radius = .1;
    body.outer_radius = .2;
    body.height       = .05;
    body.cells        = {{8, 2, 1}};
    return body;
  }

  BodyMesh
  read_ring()
  {
    BodyParameters body = ring();
    body.shape          = BodyParameters::Shape::gmsh;
    body.mesh_file      = "ring.msh";
    return read_mesh_body(body);
  }

  void
  good()
  {
    for (const unsigned int n_nodes : {8, 20, 27})
      {
        AnnulusFile(ring(), n_nodes).write_2("ring.msh");
        const BodyMesh    mesh = read_ring();
        const std::string what = std::to_string(n_nodes) + " nodes";
        check(mesh.cells.size() == 16, what + ": cells");
        check(mesh.vertices.size() == 48,
              what + ": corners alone are vertices");
        check(mesh.curved.size() == (n_nodes == 8 ? 0 : 16),
              what + ": curved cells");
        check(mesh.face_names ==
                std::vector<std::string>({"inner", "outer", "z_min", "z_max"}),
              what + ": faces of second order have names");
        for (const auto &[cell, nodes] : mesh.curved)
          check(range_of_jacobian(nodes).first > 0., what + ": right-handed");
      }
    // Mirrored: numbered the other way round as a whole.
    AnnulusFile(ring(), 27).write_2("ring.msh", [](auto x) {
      x[2] = -x[2];
      return x;
    });
    for (const auto &[cell, nodes] : read_ring().curved)
      check(range_of_jacobian(nodes).first > 0., "mirrored cells are turned");
    // Nodes in the middles of a straight cube make no curved cells.
    AnnulusFile(ring(), 27).write_2("ring.msh", [](auto x) {
      const double r = std::hypot(x[0], x[1]), h = M_PI / 8.,
                   t = std::atan2(x[1], x[0]), cell = std::floor(t / (2. * h));
      const double off = t - (2. * cell + 1.) * h;
      const double straight =
        std::abs(std::abs(off) - h) < 1e-9 ? r : r * std::cos(h);
      return decltype(x){
        {straight * std::cos(t), straight * std::sin(t), x[2]}};
    });
    check(read_ring().curved.empty(), "straight cells of second order");
  }

  template <typename Change>
  void
  refuses(const std::string &part,
          const std::string &what,
          const Change      &change)
  {
    AnnulusFile(ring(), 27).write_2("ring.msh", change);
    check_throws<InputError>(read_ring, part, "refused: " + what);
  }

  void
  bad()
  {
    const auto moves = [](const double r, const double z, const double by) {
      return [=](auto x) {
        const bool is_it = std::abs(std::hypot(x[0], x[1]) - r) < 1e-9 &&
                           std::abs(x[1]) < 1e-9 && x[0] > 0. &&
                           std::abs(x[2] - z) < 1e-9;
        if (is_it)
          x[0] += by;
        return x;
      };
    };
    refuses("folded", "a node past the end of its edge", moves(.125, 0., .018));
    refuses("too round", "a node far off", moves(.15, .025, -.06));

    // Two cells of one face: the first one of second order, the other of first.
    std::string two = version_2(Cube());
    two             = replaced(two, "$Nodes\n27", "$Nodes\n47");
    std::string  nodes, element;
    unsigned int n = 28;
    // The middles of the 12 edges of cell 0, one of them off its edge.
    for (const auto &x : {std::array<double, 3>{{.25, 0., 0.}},
                          {{0., .25, 0.}},
                          {{0., 0., .25}},
                          {{.53, .25, 0.}},
                          {{.5, 0., .25}},
                          {{.25, .5, 0.}},
                          {{.5, .5, .25}},
                          {{0., .5, .25}},
                          {{.25, 0., .5}},
                          {{0., .25, .5}},
                          {{.5, .25, .5}},
                          {{.25, .5, .5}}})
      {
        nodes += std::to_string(n) + spaced(x) + "\n";
        element += " " + std::to_string(n++);
      }
    for (; n <= 47; ++n)
      nodes += std::to_string(n) + " 9 9 9\n";
    const Cube        cube;
    const std::string first = " 5 2 11 1" + spaced(cube.cells[0]);
    two                     = replaced(two, "$EndNodes", nodes + "$EndNodes");
    two = replaced(two, first, " 17 2 11 1" + spaced(cube.cells[0]) + element);
    check_throws<InputError>([&]() { read(two); },
                             "elements 14 and 15 share corners",
                             "refused: a curved cell beside a straight one");
    check(read(replaced(two, "0.53", "0.5")).cells.size() == 8,
          "a straight cell of second order beside one of first order");
  }
} // namespace

int
main()
{
  good();
  bad();
}
