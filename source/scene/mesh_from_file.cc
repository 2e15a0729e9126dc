// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/number_text.h>

#include <squeal/scene/coarse_mesh.h>
#include <squeal/scene/mesh_cell.h>
#include <squeal/scene/mesh_materials.h>
#include <squeal/scene/mesh_selection.h>

#include <deal.II/base/tensor.h>

#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <map>
#include <set>

namespace squeal
{
  namespace
  {
    using dealii::Point;
    using dealii::Tensor;
    using Kind = MeshFile::Kind;
    using Hexahedron =
      std::array<unsigned int, 8>; /**< corners, x fastest, then y, z */
    using Quad = std::array<unsigned int, 4>;

    const char *const unnamed_face = "unnamed";

    /** Of a cell, over its diagonal: what looks for cells that may hold a point
     * counts on it. */
    constexpr double largest_bulge = .2;

    /** Below this a face is flat. */
    constexpr double flat_height = 1e-6;

    /** The faces x min, x max, y min, ... of a hexahedron. */
    constexpr std::array<Quad, 6> faces_of_hexahedron{{{{0, 2, 4, 6}},
                                                       {{1, 3, 5, 7}},
                                                       {{0, 1, 4, 5}},
                                                       {{2, 3, 6, 7}},
                                                       {{0, 1, 2, 3}},
                                                       {{4, 5, 6, 7}}}};

    std::string
    percent(const double share)
    {
      return rounded_text(100. * share, 3) + " %";
    }

    Quad
    corners_of_face(const Hexahedron &cell, const unsigned int f)
    {
      const Quad &face = faces_of_hexahedron[f];
      return {{cell[face[0]], cell[face[1]], cell[face[2]], cell[face[3]]}};
    }

    Quad
    sorted(Quad quad)
    {
      std::sort(quad.begin(), quad.end());
      return quad;
    }



    /** Makes one body of a mesh file; see read_mesh_body(). */
    class FileBody
    {
    public:
      FileBody(const BodyParameters &body)
        : body(body)
        , file(read_mesh_file(body))
        , selection(file, body)
      {
      }

      BodyMesh make();

    private:
      void         collect_hexahedra();
      void         refuse_two_cells(const MeshFile::Element &first,
                                    const MeshFile::Element &second) const;
      void         add_points(const MeshFile::Element &element);
      void         orient_hexahedra();
      void         find_boundary();
      void         name_boundary();
      bool         is_wanted(const std::string &name) const;
      void         number_unnamed_faces();
      void         add_remarks(BodyMesh &mesh) const;
      Tensor<1, 3> offset() const;
      BodyMesh     without_unused_nodes() const;
      void         add_curved_cells(BodyMesh &mesh) const;

      const BodyParameters    &body;
      const MeshFile           file;
      const MeshSelection      selection;
      std::vector<Hexahedron>  hexahedra;
      std::vector<long>        tags;   /**< of the hexahedra */
      std::vector<CellNodes>   points; /**< of the hexahedra */
      bool                     has_second_order = false;
      SharedPoints             shared_points;
      std::map<Quad, int>      face_of_quad; /**< -1: not yet named */
      std::map<Quad, Quad>     boundary;     /**< by sorted corners */
      std::vector<std::string> face_names;
    };



    void
    FileBody::collect_hexahedra()
    {
      std::map<Hexahedron, const MeshFile::Element *> known;
      has_second_order = std::any_of(file.elements.begin(),
                                     file.elements.end(),
                                     [&](const MeshFile::Element &element) {
                                       return selection.holds(element) &&
                                              element.nodes.size() > 8;
                                     });
      for (const auto &element : file.elements)
        if (selection.holds(element))
          {
            auto all = element.nodes;
            std::sort(all.begin(), all.end());
            if (std::adjacent_find(all.begin(), all.end()) != all.end())
              selection.fail("has a collapsed cell: element " +
                             std::to_string(element.tag) +
                             " names a node twice");
            Hexahedron corners;
            std::copy_n(element.nodes.begin(), 8, corners.begin());
            std::sort(corners.begin(), corners.end());
            const auto [first, is_new] = known.emplace(corners, &element);
            if (!is_new)
              {
                refuse_two_cells(*first->second, element);
                continue;
              }
            const auto &n = element.nodes;
            hexahedra.push_back(
              {{n[0], n[1], n[3], n[2], n[4], n[5], n[7], n[6]}});
            tags.push_back(element.tag);
            add_points(element);
          }
    }

    /** Format 2 of Gmsh repeats a cell for each physical group that it is in;
     * otherwise cells of the same corners are two. */
    void
    FileBody::refuse_two_cells(const MeshFile::Element &first,
                               const MeshFile::Element &second) const
    {
      if (!file.repeats_cells || first.nodes != second.nodes)
        selection.fail("has two cells at one place: elements " +
                       std::to_string(first.tag) + " and " +
                       std::to_string(second.tag) +
                       " have the same corners: leave one of them out");
    }

    void
    FileBody::add_points(const MeshFile::Element &element)
    {
      points.push_back(nodes_of_hexahedron(file, element));
      if (bulge_of(points.back()) > largest_bulge)
        selection.fail(
          "has a cell that is too round: a node of element " +
          std::to_string(element.tag) + " lies " +
          percent(bulge_of(points.back())) +
          " of its diagonal from where its corners have it; at most " +
          percent(largest_bulge) + " are allowed: use more cells there");
      if (!has_second_order)
        return;
      if (const auto other = shared_points.disagrees(element, points.back()))
        selection.fail(
          "does not fit together: elements " + std::to_string(*other) +
          " and " + std::to_string(element.tag) +
          " share corners, but not the points between them: mesh both in "
          "second order or both in first order");
    }



    void
    FileBody::orient_hexahedra()
    {
      const double      flat = 1e-10;
      std::vector<long> inverted, bad;
      for (unsigned int i = 0; i < hexahedra.size(); ++i)
        {
          const auto range = range_of_jacobian(points[i]);
          if (range.second < -flat)
            inverted.push_back(tags[i]);
          else if (!(range.first > flat))
            bad.push_back(tags[i]);
        }
      if (!bad.empty())
        selection.fail("has " + std::to_string(bad.size()) +
                       (bad.size() == 1 ? " cell" : " cells") +
                       " with a folded or flat corner, first element " +
                       std::to_string(bad.front()) +
                       ": improve the mesh there");
      // A mirrored mesh is numbered the other way round as a whole; a few
      // such cells lie on top of their neighbours.
      if (!inverted.empty() && inverted.size() < hexahedra.size())
        selection.fail(
          "has " + std::to_string(inverted.size()) +
          (inverted.size() == 1 ? " inverted cell" : " inverted cells") +
          " (negative volume), first element " +
          std::to_string(inverted.front()) +
          ": improve the mesh there or reverse the volume");
      if (!inverted.empty())
        for (unsigned int i = 0; i < hexahedra.size(); ++i)
          {
            auto &cell = hexahedra[i];
            std::swap_ranges(cell.begin(), cell.begin() + 4, cell.begin() + 4);
            auto &x = points[i];
            std::swap_ranges(x.begin(), x.begin() + 9, x.begin() + 18);
          }
    }



    void
    FileBody::find_boundary()
    {
      std::map<Quad, std::vector<Quad>> faces;
      for (const auto &cell : hexahedra)
        for (unsigned int f = 0; f < 6; ++f)
          {
            const Quad quad = corners_of_face(cell, f);
            faces[sorted(quad)].push_back(quad);
          }
      for (const auto &[key, quads] : faces)
        {
          if (quads.size() > 2)
            selection.fail(
              "has cells that overlap: " + std::to_string(quads.size()) +
              " of them share one face");
          if (quads.size() == 1)
            boundary[key] = quads.front();
        }
    }



    void
    FileBody::name_boundary()
    {
      for (const auto &[key, quad] : boundary)
        face_of_quad[key] = -1;
      // Faces are numbered by ascending physical tag.
      std::map<int, std::vector<Quad>> quads_of_tag;
      for (const auto &element : file.elements)
        if (element.kind == Kind::quadrilateral)
          {
            const Quad key = sorted({{element.nodes[0],
                                      element.nodes[1],
                                      element.nodes[2],
                                      element.nodes[3]}});
            if (face_of_quad.count(key) > 0)
              for (const int tag : file.groups[element.group])
                quads_of_tag[tag].push_back(key);
          }
      std::set<int> tags;
      for (const auto &[tag, quads] : quads_of_tag)
        tags.insert(tag);
      for (const auto &[tag, quads] : quads_of_tag)
        {
          const std::string name = name_of_group(file.surface_names, tag);
          if (!is_wanted(name))
            continue;
          if (const std::string two = two_meanings_of(
                name, file.surface_names, tags, "physical surface");
              !two.empty())
            selection.fail("has on the body " + two);
          const auto it = std::find(face_names.begin(), face_names.end(), name);
          const int  number = it - face_names.begin();
          if (it == face_names.end())
            face_names.push_back(name);
          for (const auto &key : quads)
            {
              int &face = face_of_quad[key];
              if (face >= 0 && face != number)
                selection.fail("gives one cell face to the surfaces '" +
                               face_names[face] + "' and '" + name +
                               "': a face has one name; say with 'Mesh faces' "
                               "which of them are meant");
              face = number;
            }
        }
      for (const auto &name : body.mesh_faces)
        if (std::count(face_names.begin(), face_names.end(), name) == 0)
          selection.fail("has no surface or set '" + name +
                         "' on the body ('Mesh faces')");
    }

    /** Surfaces and sets may overlap where some are not asked for. */
    bool
    FileBody::is_wanted(const std::string &name) const
    {
      const auto &names = body.mesh_faces;
      return names.empty() ||
             std::find(names.begin(), names.end(), name) != names.end();
    }



    /** Every face of the surface gets a number: without one it would count as
     * face 0 of body 0. */
    void
    FileBody::number_unnamed_faces()
    {
      const bool all_named = std::none_of(face_of_quad.begin(),
                                          face_of_quad.end(),
                                          [](auto &f) { return f.second < 0; });
      if (!all_named)
        {
          auto it =
            std::find(face_names.begin(), face_names.end(), unnamed_face);
          const int number = it - face_names.begin();
          if (it == face_names.end())
            face_names.push_back(unnamed_face);
          for (auto &[key, face] : face_of_quad)
            if (face < 0)
              face = number;
        }
      if (face_names.size() > max_faces_per_body)
        selection.fail("names " + std::to_string(face_names.size()) +
                       " faces of the body; at most " +
                       std::to_string(max_faces_per_body) + " are supported");
    }



    Tensor<1, 3>
    FileBody::offset() const
    {
      const auto &x = body.position;
      return Point<3>(x[0], x[1], x[2]);
    }

    BodyMesh
    FileBody::without_unused_nodes() const
    {
      BodyMesh                  mesh;
      std::vector<unsigned int> number(file.nodes.size(), -1u);
      for (const auto &cell : hexahedra)
        {
          mesh.cells.emplace_back();
          for (unsigned int v = 0; v < 8; ++v)
            {
              unsigned int &n = number[cell[v]];
              if (n == -1u)
                {
                  n = mesh.vertices.size();
                  mesh.vertices.push_back(file.nodes[cell[v]] + offset());
                }
              mesh.cells.back().vertices[v] = n;
            }
        }
      for (const auto &[key, quad] : boundary)
        {
          mesh.boundary.emplace_back();
          for (unsigned int v = 0; v < 4; ++v)
            mesh.boundary.back().vertices[v] = number[quad[v]];
          mesh.boundary.back().boundary_id = face_of_quad.at(key);
        }
      mesh.face_names = face_names;
      add_curved_cells(mesh);
      return mesh;
    }

    void
    FileBody::add_curved_cells(BodyMesh &mesh) const
    {
      for (unsigned int i = 0; i < hexahedra.size(); ++i)
        if (has_second_order && is_curved(points[i]))
          {
            mesh.curved[i] = points[i];
            for (auto &x : mesh.curved[i])
              x += offset();
            for (unsigned int f = 0; f < 6; ++f)
              if (const auto it =
                    face_of_quad.find(sorted(corners_of_face(hexahedra[i], f)));
                  it != face_of_quad.end() &&
                  height_of_face(points[i], f) > flat_height)
                mesh.round_faces.insert(it->second);
          }
    }



    void
    FileBody::add_remarks(BodyMesh &mesh) const
    {
      std::string names;
      for (const auto &name : file.passed_over)
        names += (names.empty() ? "" : ", ") + name;
      if (!names.empty())
        mesh.remarks.push_back(
          "mesh file '" + body.mesh_file + "': not followed are " + names +
          ": what they hold, tie, load, remove or add to mass, stiffness and "
          "damping is for the scene");
      if (const auto remark = material_remark(body, file); !remark.empty())
        mesh.remarks.push_back(remark);
    }



    BodyMesh
    FileBody::make()
    {
      collect_hexahedra();
      orient_hexahedra();
      find_boundary();
      name_boundary();
      number_unnamed_faces();
      BodyMesh mesh         = without_unused_nodes();
      mesh.touching_volumes = selection.touching_volumes();
      for (const auto &tie : file.ties)
        mesh.file_ties.push_back({{tie.name, tie.source, tie.target}});
      add_remarks(mesh);
      dealii::GridTools::consistently_order_cells(mesh.cells);
      return mesh;
    }
  } // namespace



  BodyMesh
  read_mesh_body(const BodyParameters &body)
  {
    if (body.mesh_file.empty())
      throw InputError("Scene/Body " + body.name +
                       "/Mesh file: is empty: name the mesh file of the body");
    return FileBody(body).make();
  }
} // namespace squeal
