// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/parameters/face_geometry.h>
#include <squeal/scene/coarse_mesh.h>
#include <squeal/scene/turning.h>

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/tria.h>

#include <cmath>

namespace squeal
{
  namespace
  {
    using dealii::CellData;
    using dealii::Point;

    /**
     * A structured mesh from a map of the lattice (i, j, k) to points. In the
     * first direction it closes on itself when @p periodic. @p face_of gives
     * the face number of each side: i min, i max, j min, j max, k min, k max.
     */
    template <typename Map>
    BodyMesh
    structured_mesh(const std::array<unsigned int, 3> &n,
                    const bool                         periodic,
                    const std::array<int, 6>          &face_of,
                    const Map                         &map)
    {
      BodyMesh           mesh;
      const unsigned int n_i = periodic ? n[0] : n[0] + 1;
      for (unsigned int k = 0; k <= n[2]; ++k)
        for (unsigned int j = 0; j <= n[1]; ++j)
          for (unsigned int i = 0; i < n_i; ++i)
            mesh.vertices.push_back(map(i, j, k));
      const auto vertex = [&](unsigned int i, unsigned int j, unsigned int k) {
        return (k * (n[1] + 1) + j) * n_i + (periodic ? i % n[0] : i);
      };
      const auto add_face = [&](const std::array<unsigned int, 4> &v,
                                const int                          face) {
        if (face < 0)
          return;
        CellData<2> quad;
        for (unsigned int c = 0; c < 4; ++c)
          quad.vertices[c] = v[c];
        quad.boundary_id = face;
        mesh.boundary.push_back(quad);
      };
      for (unsigned int k = 0; k < n[2]; ++k)
        for (unsigned int j = 0; j < n[1]; ++j)
          for (unsigned int i = 0; i < n[0]; ++i)
            {
              CellData<3>                 cell;
              std::array<unsigned int, 8> v;
              for (unsigned int c = 0; c < 8; ++c)
                v[c] = vertex(i + (c & 1), j + ((c >> 1) & 1), k + (c >> 2));
              for (unsigned int c = 0; c < 8; ++c)
                cell.vertices[c] = v[c];
              mesh.cells.push_back(cell);
              if (i == 0)
                add_face({{v[0], v[2], v[4], v[6]}}, face_of[0]);
              if (i + 1 == n[0])
                add_face({{v[1], v[3], v[5], v[7]}}, face_of[1]);
              if (j == 0)
                add_face({{v[0], v[1], v[4], v[5]}}, face_of[2]);
              if (j + 1 == n[1])
                add_face({{v[2], v[3], v[6], v[7]}}, face_of[3]);
              if (k == 0)
                add_face({{v[0], v[1], v[2], v[3]}}, face_of[4]);
              if (k + 1 == n[2])
                add_face({{v[4], v[5], v[6], v[7]}}, face_of[5]);
            }
      return mesh;
    }



    BodyMesh
    block_mesh(const BodyParameters &b)
    {
      return structured_mesh(
        b.cells,
        false,
        {{0, 1, 2, 3, 4, 5}},
        [&](const unsigned int i, const unsigned int j, const unsigned int k) {
          return Point<3>(
            b.position[0] + b.size[0] * (double(i) / b.cells[0] - 0.5),
            b.position[1] + b.size[1] * (double(j) / b.cells[1] - 0.5),
            b.position[2] + b.size[2] * (double(k) / b.cells[2]));
        });
    }



    BodyMesh
    annulus_mesh(const BodyParameters &b)
    {
      if (b.cells[0] < 3)
        throw InputError("Scene/Body " + b.name +
                         "/Cells: an annulus needs at least 3 cells round its "
                         "circumference");
      // Lattice (theta, r, z) is left-handed: run theta backwards.
      return structured_mesh(
        b.cells,
        true,
        {{-1, -1, 0, 1, 2, 3}},
        [&](const unsigned int i, const unsigned int j, const unsigned int k) {
          const double theta = -2. * M_PI * i / b.cells[0];
          const double r = b.inner_radius + (b.outer_radius - b.inner_radius) *
                                              (double(j) / b.cells[1]);
          return Point<3>(b.position[0] + r * std::cos(theta),
                          b.position[1] + r * std::sin(theta),
                          b.position[2] + b.height * (double(k) / b.cells[2]));
        });
    }



    /** A disc of 5 blocks, refined until its rim has the asked number of
     * cells, swept along z. */
    BodyMesh
    cylinder_mesh(const BodyParameters &b)
    {
      dealii::Triangulation<2> disc;
      dealii::GridGenerator::hyper_ball(
        disc, dealii::Point<2>(b.position[0], b.position[1]), b.outer_radius);
      for (unsigned int n = 4; n < b.cells[0]; n *= 2)
        disc.refine_global();
      dealii::Triangulation<2> flat;
      dealii::GridGenerator::flatten_triangulation(disc, flat);

      BodyMesh           mesh;
      const unsigned int n_2d = flat.n_vertices();
      for (unsigned int k = 0; k <= b.cells[2]; ++k)
        for (const auto &p : flat.get_vertices())
          mesh.vertices.emplace_back(
            p[0], p[1], b.position[2] + b.height * (double(k) / b.cells[2]));
      for (unsigned int k = 0; k < b.cells[2]; ++k)
        for (const auto &quad : flat.active_cell_iterators())
          {
            CellData<3> cell;
            for (unsigned int c = 0; c < 4; ++c)
              {
                cell.vertices[c]     = k * n_2d + quad->vertex_index(c);
                cell.vertices[c + 4] = (k + 1) * n_2d + quad->vertex_index(c);
              }
            mesh.cells.push_back(cell);
            const auto add_face = [&](std::array<unsigned int, 4> v, int face) {
              CellData<2> f;
              for (unsigned int c = 0; c < 4; ++c)
                f.vertices[c] = v[c];
              f.boundary_id = face;
              mesh.boundary.push_back(f);
            };
            const auto &v = cell.vertices;
            if (k == 0)
              add_face({{v[0], v[1], v[2], v[3]}}, 1);
            if (k + 1 == b.cells[2])
              add_face({{v[4], v[5], v[6], v[7]}}, 2);
            for (const unsigned int f : quad->face_indices())
              if (quad->face(f)->at_boundary())
                {
                  const unsigned int a = quad->face(f)->vertex_index(0);
                  const unsigned int c = quad->face(f)->vertex_index(1);
                  add_face({{k * n_2d + a,
                             k * n_2d + c,
                             (k + 1) * n_2d + a,
                             (k + 1) * n_2d + c}},
                           0);
                }
          }
      return mesh;
    }



    /** The mesh where the numbers of @p body describe it, not turned. */
    BodyMesh
    mesh_as_described(const BodyParameters &body)
    {
      BodyMesh mesh;
      switch (body.shape)
        {
        case BodyParameters::Shape::annulus:
          mesh = annulus_mesh(body);
          break;
        case BodyParameters::Shape::block:
          mesh = block_mesh(body);
          break;
        case BodyParameters::Shape::cylinder:
          mesh = cylinder_mesh(body);
          break;
        case BodyParameters::Shape::gmsh:
        case BodyParameters::Shape::abaqus:
        case BodyParameters::Shape::nastran:
          return read_mesh_body(body);
        case BodyParameters::Shape::layer: // see make_layer_mesh()
        case BodyParameters::Shape::rigid:
          return mesh;
        }
      mesh.face_names = prm::faces_of(body.shape);
      return mesh;
    }



    void
    turn(const BodyParameters &body, BodyMesh &mesh)
    {
      for (auto &vertex : mesh.vertices)
        vertex = turned_point(body, vertex);
      for (auto &[cell, nodes] : mesh.curved)
        for (auto &node : nodes)
          node = turned_point(body, node);
    }
  } // namespace



  BodyMesh
  make_body_mesh(const BodyParameters &body)
  {
    BodyMesh mesh = mesh_as_described(body);
    if (body.angle != 0.)
      turn(body, mesh);
    return mesh;
  }
} // namespace squeal
