// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/scene/matching_faces.h>
#include <squeal/scene/tied_faces.h>

#include <deal.II/base/geometry_info.h>

#include <algorithm>
#include <limits>
#include <set>

namespace squeal
{
  using dealii::Point;

  namespace
  {
    using Geometry = dealii::GeometryInfo<3>;
    using Corners  = std::array<unsigned int, 4>;

    Corners
    sorted(Corners corners)
    {
      std::sort(corners.begin(), corners.end());
      return corners;
    }

    double
    extent(const CoarseMesh &mesh, const std::set<unsigned int> &vertices)
    {
      double size = 0.;
      for (const unsigned int v : vertices)
        size = std::max(
          size, mesh.vertices[v].distance(mesh.vertices[*vertices.begin()]));
      return size;
    }

    /** The four corners of face @p f of a cell, the first direction fastest. */
    Corners
    corners_of(const dealii::CellData<3> &cell, const unsigned int f)
    {
      Corners corners;
      for (unsigned int v = 0; v < corners.size(); ++v)
        corners[v] = cell.vertices[Geometry::face_to_cell_vertices(f, v)];
      return corners;
    }

    /** The nodes of face @p f of a cell of second order between its corners, or
     * where they are if it is not curved: of the four edges and the middle. m
     */
    std::vector<Point<3>>
    nodes_between(const CoarseMesh  &mesh,
                  const unsigned int cell,
                  const unsigned int f)
    {
      std::vector<Point<3>> points;
      if (const auto curved = mesh.curved.find(cell);
          curved != mesh.curved.end())
        {
          for (unsigned int n = 0; n < 27; ++n)
            {
              const std::array<unsigned int, 3> place{
                {n % 3, n / 3 % 3, n / 9}};
              if (place[f / 2] == 2 * (f % 2) &&
                  std::count(place.begin(), place.end(), 1u) > 0)
                points.push_back(curved->second[n]);
            }
          return points;
        }
      const Corners c = corners_of(mesh.cells[cell], f);
      const auto    x = [&](const unsigned int v) -> const Point<3>    &{
        return mesh.vertices[c[v]];
      };
      for (const auto &[a, b] : {std::make_pair(0u, 1u),
                                 std::make_pair(2u, 3u),
                                 std::make_pair(0u, 2u),
                                 std::make_pair(1u, 3u)})
        points.push_back(x(a) + .5 * (x(b) - x(a)));
      points.push_back(points[0] + .5 * (points[1] - points[0]));
      return points;
    }

    /** The quads of a face by their corners, ascending, with the nodes between
     * these. */
    std::map<Corners, std::vector<Point<3>>>
    quads_of(const CoarseMesh &mesh, const unsigned int id)
    {
      std::map<Corners, std::vector<Point<3>>> quads;
      for (const auto &quad : mesh.boundary.boundary_quads)
        if (quad.boundary_id == id)
          quads[sorted({{quad.vertices[0],
                         quad.vertices[1],
                         quad.vertices[2],
                         quad.vertices[3]}})];
      for (unsigned int c = 0; c < mesh.cells.size(); ++c)
        for (const unsigned int f : Geometry::face_indices())
          if (const auto quad =
                quads.find(sorted(corners_of(mesh.cells[c], f)));
              quad != quads.end())
            quad->second = nodes_between(mesh, c, f);
      return quads;
    }

    bool
    are_at_same_places(const std::vector<Point<3>> &a,
                       const std::vector<Point<3>> &b,
                       const double                 tolerance)
    {
      return std::all_of(a.begin(), a.end(), [&](const Point<3> &x) {
        return std::any_of(b.begin(), b.end(), [&](const Point<3> &y) {
          return x.distance(y) < tolerance;
        });
      });
    }
  } // namespace



  std::map<unsigned int, unsigned int>
  matching_vertices(const CoarseMesh  &mesh,
                    const unsigned int source,
                    const unsigned int target)
  {
    const std::set<unsigned int> of_source = vertices_of_face(mesh, source),
                                 of_target = vertices_of_face(mesh, target);
    std::map<unsigned int, unsigned int> partner;
    const double tolerance = 1e-6 * extent(mesh, of_source);
    for (const unsigned int s : of_source)
      for (const unsigned int t : of_target)
        if (mesh.vertices[s].distance(mesh.vertices[t]) < tolerance)
          partner[s] = t;
    if (partner.size() != of_source.size() ||
        of_source.size() != of_target.size())
      return {};

    const auto source_quads = quads_of(mesh, source),
               target_quads = quads_of(mesh, target);
    for (const auto &[corners, nodes] : source_quads)
      {
        Corners across;
        for (unsigned int v = 0; v < across.size(); ++v)
          across[v] = partner.at(corners[v]);
        const auto quad = target_quads.find(sorted(across));
        if (quad == target_quads.end() ||
            !are_at_same_places(nodes, quad->second, tolerance))
          return {};
      }
    return source_quads.size() == target_quads.size()
             ? partner
             : std::map<unsigned int, unsigned int>();
  }
} // namespace squeal
