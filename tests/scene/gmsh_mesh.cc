// SPDX-License-Identifier: LGPL-2.1-or-later

// What is read from a Gmsh file is the mesh that was meant, in both formats
// and however its cells are numbered.

#include <squeal/base/exceptions.h>

#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria.h>

#include "gmsh_cube.h"

#include <functional>
#include <map>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  /** Checks counts, volume, place and the area of every face. */
  void
  check_mesh(const BodyMesh                      &mesh,
             const unsigned int                   n_cells,
             const double                         volume,
             const double                         top,
             const std::map<std::string, double> &areas,
             const std::string                   &what)
  {
    check(mesh.cells.size() == n_cells, what + ": number of cells");
    dealii::SubCellData boundary;
    boundary.boundary_quads = mesh.boundary;
    dealii::Triangulation<3> triangulation;
    triangulation.create_triangulation(mesh.vertices, mesh.cells, boundary);
    check(triangulation.n_used_vertices() == mesh.vertices.size(),
          what + ": every node is used");
    check_close(dealii::GridTools::volume(triangulation),
                volume,
                1e-12,
                what + ": volume");
    const auto box = dealii::GridTools::compute_bounding_box(triangulation);
    check_close(box.get_boundary_points().first[0], 10., 1e-12, what + ": x");
    check_close(box.get_boundary_points().second[2], top, 1e-12, what + ": z");

    std::map<std::string, double> found;
    for (const auto &face : triangulation.active_face_iterators())
      if (face->at_boundary())
        found[mesh.face_names[face->boundary_id()]] += face->measure();
    check(found.size() == areas.size(), what + ": number of faces");
    for (const auto &[name, area] : areas)
      check_close(found[name], area, 1e-12, what + ": area of " + name);
  }

  /** Every cell turned into another of its 24 positions. */
  Cube
  turned(Cube cube)
  {
    const auto about_z = [](const std::array<int, 8> &c) {
      return std::array<int, 8>{
        {c[1], c[2], c[3], c[0], c[5], c[6], c[7], c[4]}};
    };
    const auto about_x = [](const std::array<int, 8> &c) {
      return std::array<int, 8>{
        {c[3], c[2], c[6], c[7], c[0], c[1], c[5], c[4]}};
    };
    for (unsigned int i = 0; i < 8; ++i)
      {
        for (unsigned int n = 0; n < i % 4; ++n)
          cube.cells[i] = about_z(cube.cells[i]);
        for (unsigned int n = 0; n < i / 2; ++n)
          cube.cells[i] = about_x(cube.cells[i]);
        for (unsigned int n = 0; n < (i + 1) % 3; ++n)
          cube.cells[i] = about_z(cube.cells[i]);
      }
    return cube;
  }

  Cube
  mirrored(Cube cube)
  {
    for (auto &cell : cube.cells)
      std::swap_ranges(cell.begin(), cell.begin() + 4, cell.begin() + 4);
    return cube;
  }

  void
  good_meshes()
  {
    const Cube                          cube;
    const std::map<std::string, double> whole{
      {"left", 1.}, {"right side", 1.}, {"unnamed", 4.}};
    const std::map<std::string, double> half{
      {"left", .5}, {"right side", .5}, {"middle", 1.}, {"unnamed", 2.}};
    const std::map<std::string, std::function<std::string(const Cube &)>>
      formats{{"format 2.2", version_2}, {"format 4.1", version_4}};
    for (const auto &[name, format] : formats)
      {
        check_mesh(read(format(cube)), 8, 1., 31., whole, name);
        check_mesh(read(format(cube), "lower"),
                   4,
                   .5,
                   30.5,
                   half,
                   name + ", one physical volume");
        check_mesh(read(format(turned(cube))),
                   8,
                   1.,
                   31.,
                   whole,
                   name + ", cells numbered from any corner");
        check_mesh(read(format(mirrored(cube)), "upper"),
                   4,
                   .5,
                   31.,
                   half,
                   name + ", all cells inverted");
      }
    check(read(version_2(cube)).face_names ==
            std::vector<std::string>({"left", "right side", "unnamed"}),
          "faces are numbered by physical tag");

    std::string text = version_2(cube);
    text             = replaced(text, names, "");
    check(read(text, "11").face_names ==
            std::vector<std::string>({"1", "2", "3", "unnamed"}),
          "groups without a name go by their number");
    text = with_element(cube, "5 2 13 1" + spaced(cube.cells[0]));
    check(read(text).cells.size() == 8,
          "a cell repeated for a second group counts once");
    check(read(text, "13").cells.size() == 1,
          "and belongs to the second group, too");
    check(read("$Comments\nby hand\n$EndComments\n" + version_2(cube))
              .cells.size() == 8,
          "comments come first");
  }
} // namespace

int
main()
{
  good_meshes();
}
