// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/unknown_choice.h>

#include <squeal/scene/coarse_mesh.h>
#include <squeal/scene/gmsh_file.h>

#include <deal.II/base/tensor.h>

#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <set>

namespace squeal
{
  namespace
  {
    using dealii::Point;
    using dealii::Tensor;
    using Kind = GmshFile::Kind;
    using Hexahedron =
      std::array<unsigned int, 8>; /**< corners, x fastest, then y, z */
    using Quad = std::array<unsigned int, 4>;

    const char *const unnamed_face = "unnamed";

    /** The faces x min, x max, y min, ... of a hexahedron. */
    constexpr std::array<Quad, 6> faces_of_hexahedron{{{{0, 2, 4, 6}},
                                                       {{1, 3, 5, 7}},
                                                       {{0, 1, 4, 5}},
                                                       {{2, 3, 6, 7}},
                                                       {{0, 1, 2, 3}},
                                                       {{4, 5, 6, 7}}}};

    bool
    is_volume(const Kind kind)
    {
      return kind != Kind::low_dimensional && kind != Kind::quadrilateral &&
             kind != Kind::other_surface;
    }

    std::string
    plural_of(const Kind kind)
    {
      switch (kind)
        {
        case Kind::tetrahedron:
          return "tetrahedra";
        case Kind::wedge:
          return "wedges";
        case Kind::pyramid:
          return "pyramids";
        case Kind::higher_order_hexahedron:
          return "hexahedra of second or higher order";
        case Kind::other_volume:
          return "cells of an unknown kind";
        case Kind::low_dimensional:
        case Kind::quadrilateral:
        case Kind::other_surface:
        case Kind::hexahedron:
          break;
        }
      unknown_choice("kind of cell to refuse");
    }

    /** The name of a physical group, or its number where it has none. */
    std::string
    name_of(const std::map<int, std::string> &names, const int tag)
    {
      const auto it = names.find(tag);
      return it == names.end() ? std::to_string(tag) : it->second;
    }

    Quad
    sorted(Quad quad)
    {
      std::sort(quad.begin(), quad.end());
      return quad;
    }



    /** Makes one body of a Gmsh file; see read_gmsh_body(). */
    class GmshBody
    {
    public:
      GmshBody(const BodyParameters &body)
        : body(body)
        , file(read_gmsh_file(body.mesh_file))
      {
      }

      BodyMesh make();

    private:
      [[noreturn]] void fail(const std::string &text) const;
      bool              is_selected(const GmshFile::Element &element) const;
      void              check_physical_volume() const;
      void              check_kinds() const;
      void              collect_hexahedra();
      void              orient_hexahedra();
      void              find_boundary();
      void              check_connected() const;
      void              name_boundary();
      void              number_unnamed_faces();
      std::vector<std::string> touching_volumes() const;
      BodyMesh                 without_unused_nodes() const;

      const BodyParameters    &body;
      const GmshFile           file;
      std::vector<Hexahedron>  hexahedra;
      std::vector<long>        tags;         /**< of the hexahedra */
      std::map<Quad, int>      face_of_quad; /**< -1: not yet named */
      std::map<Quad, Quad>     boundary;     /**< by sorted corners */
      std::vector<std::string> face_names;
    };



    void
    GmshBody::fail(const std::string &text) const
    {
      throw InputError("body '" + body.name + "': mesh file '" +
                       body.mesh_file + "' " + text);
    }

    bool
    GmshBody::is_selected(const GmshFile::Element &element) const
    {
      if (!is_volume(element.kind))
        return false;
      if (body.physical_volume.empty())
        return true;
      const auto &group = file.groups[element.group];
      return std::any_of(group.begin(), group.end(), [&](const int tag) {
        return name_of(file.volume_names, tag) == body.physical_volume;
      });
    }



    void
    GmshBody::check_physical_volume() const
    {
      if (body.physical_volume.empty())
        return;
      std::set<std::string> names;
      for (const auto &[tag, name] : file.volume_names)
        names.insert(name);
      for (const auto &element : file.elements)
        if (is_volume(element.kind))
          for (const int tag : file.groups[element.group])
            names.insert(name_of(file.volume_names, tag));
      if (names.count(body.physical_volume) > 0)
        return;
      std::string list;
      for (const auto &name : names)
        list += (list.empty() ? "" : ", ") + name;
      fail("has no physical volume '" + body.physical_volume +
           "'; there are: " + (list.empty() ? "none" : list));
    }



    void
    GmshBody::check_kinds() const
    {
      std::map<Kind, unsigned int> count;
      for (const auto &element : file.elements)
        if (is_selected(element))
          ++count[element.kind];
      if (count.empty())
        fail((body.physical_volume.empty()
                ? "holds no volume cells"
                : "holds no cells of physical volume '" + body.physical_volume +
                    "'") +
             std::string(": mesh it in three dimensions and give the volume a "
                         "physical group"));
      std::string others;
      for (const auto &[kind, n] : count)
        if (kind != Kind::hexahedron)
          others += (others.empty() ? "" : ", ") + plural_of(kind) + " (" +
                    std::to_string(n) + ")";
      const bool only_order = count.count(Kind::higher_order_hexahedron) == 1 &&
                              count.size() <= 1 + count.count(Kind::hexahedron);
      if (!others.empty())
        fail("holds " + others +
             ", but only hexahedra with 8 nodes are used: " +
             (only_order ? "save it with Mesh.ElementOrder = 1 (the degree is "
                           "set in Discretization)"
                         : "use transfinite or extruded meshes with Recombine, "
                           "or Mesh.SubdivisionAlgorithm = 2"));
    }



    void
    GmshBody::collect_hexahedra()
    {
      // Format 2 repeats a cell for each physical group that it is in.
      std::set<std::array<unsigned int, 8>> known;
      for (const auto &element : file.elements)
        if (is_selected(element))
          {
            auto corners = element.nodes;
            std::sort(corners.begin(), corners.end());
            if (std::adjacent_find(corners.begin(), corners.end()) !=
                corners.end())
              fail("has a collapsed cell: element " +
                   std::to_string(element.tag) + " names a node twice");
            if (!known.insert(corners).second)
              continue;
            const auto &n = element.nodes;
            hexahedra.push_back(
              {{n[0], n[1], n[3], n[2], n[4], n[5], n[7], n[6]}});
            tags.push_back(element.tag);
          }
    }



    /** Smallest and largest Jacobian determinant at the corners, relative to
     * the cube of the longest edge. */
    std::pair<double, double>
    range_of_jacobian(const Hexahedron            &cell,
                      const std::vector<Point<3>> &nodes)
    {
      double smallest = std::numeric_limits<double>::max();
      double largest = -smallest, longest = 0.;
      for (unsigned int v = 0; v < 8; ++v)
        {
          std::array<Tensor<1, 3>, 3> edges;
          for (unsigned int d = 0; d < 3; ++d)
            {
              edges[d] = nodes[cell[v | 1 << d]] - nodes[cell[v & ~(1 << d)]];
              longest  = std::max(longest, edges[d].norm());
            }
          const double jacobian =
            dealii::cross_product_3d(edges[0], edges[1]) * edges[2];
          smallest = std::min(smallest, jacobian);
          largest  = std::max(largest, jacobian);
        }
      const double scale = 1. / (longest * longest * longest);
      return {smallest * scale, largest * scale};
    }



    void
    GmshBody::orient_hexahedra()
    {
      const double      flat = 1e-10;
      std::vector<long> inverted, bad;
      for (unsigned int i = 0; i < hexahedra.size(); ++i)
        {
          const auto range = range_of_jacobian(hexahedra[i], file.nodes);
          if (range.second < -flat)
            inverted.push_back(tags[i]);
          else if (!(range.first > flat))
            bad.push_back(tags[i]);
        }
      if (!bad.empty())
        fail("has " + std::to_string(bad.size()) +
             (bad.size() == 1 ? " cell" : " cells") +
             " with a folded or flat corner, first element " +
             std::to_string(bad.front()) + ": improve the mesh there");
      // A mirrored mesh is numbered the other way round as a whole; a few
      // such cells lie on top of their neighbours.
      if (!inverted.empty() && inverted.size() < hexahedra.size())
        fail("has " + std::to_string(inverted.size()) +
             (inverted.size() == 1 ? " inverted cell" : " inverted cells") +
             " (negative volume), first element " +
             std::to_string(inverted.front()) +
             ": improve the mesh there or reverse the volume");
      if (!inverted.empty())
        for (auto &cell : hexahedra)
          std::swap_ranges(cell.begin(), cell.begin() + 4, cell.begin() + 4);
    }



    void
    GmshBody::find_boundary()
    {
      std::map<Quad, std::vector<Quad>> faces;
      for (const auto &cell : hexahedra)
        for (const auto &face : faces_of_hexahedron)
          {
            const Quad quad{
              {cell[face[0]], cell[face[1]], cell[face[2]], cell[face[3]]}};
            faces[sorted(quad)].push_back(quad);
          }
      for (const auto &[key, quads] : faces)
        {
          if (quads.size() > 2)
            fail("has cells that overlap: " + std::to_string(quads.size()) +
                 " of them share one face");
          if (quads.size() == 1)
            boundary[key] = quads.front();
        }
    }



    void
    GmshBody::check_connected() const
    {
      std::vector<unsigned int> parent(file.nodes.size());
      std::iota(parent.begin(), parent.end(), 0);
      const auto root = [&](unsigned int n) {
        while (parent[n] != n)
          n = parent[n] = parent[parent[n]];
        return n;
      };
      for (const auto &cell : hexahedra)
        for (const unsigned int n : cell)
          parent[root(n)] = root(cell[0]);
      std::set<unsigned int> parts;
      for (const auto &cell : hexahedra)
        parts.insert(root(cell[0]));
      if (parts.size() > 1)
        fail("falls into " + std::to_string(parts.size()) +
             " parts that share no nodes: merge coincident nodes (Coherence "
             "Mesh), or make each physical volume a body of its own");
    }



    void
    GmshBody::name_boundary()
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
      for (const auto &[tag, quads] : quads_of_tag)
        {
          const std::string name = name_of(file.surface_names, tag);
          const auto it = std::find(face_names.begin(), face_names.end(), name);
          const int  number = it - face_names.begin();
          if (it == face_names.end())
            face_names.push_back(name);
          for (const auto &key : quads)
            {
              int &face = face_of_quad[key];
              if (face >= 0 && face != number)
                fail("gives one cell face to the physical surfaces '" +
                     face_names[face] + "' and '" + name +
                     "': a face has one name");
              face = number;
            }
        }
    }



    /** Every face of the surface gets a number: without one it would count as
     * face 0 of body 0. */
    void
    GmshBody::number_unnamed_faces()
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
        fail("names " + std::to_string(face_names.size()) +
             " faces of the body; at most " +
             std::to_string(max_faces_per_body) + " are supported");
    }



    BodyMesh
    GmshBody::without_unused_nodes() const
    {
      BodyMesh                  mesh;
      std::vector<unsigned int> number(file.nodes.size(), -1u);
      const Point<3>            offset(
        body.position[0], body.position[1], body.position[2]);
      for (const auto &cell : hexahedra)
        {
          mesh.cells.emplace_back();
          for (unsigned int v = 0; v < 8; ++v)
            {
              unsigned int &n = number[cell[v]];
              if (n == -1u)
                {
                  n = mesh.vertices.size();
                  mesh.vertices.push_back(file.nodes[cell[v]] + offset);
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
      return mesh;
    }



    std::vector<std::string>
    GmshBody::touching_volumes() const
    {
      std::vector<bool> own(file.nodes.size(), false);
      for (const auto &cell : hexahedra)
        for (const unsigned int n : cell)
          own[n] = true;
      std::set<std::string> names;
      for (const auto &element : file.elements)
        if (element.kind == Kind::hexahedron && !is_selected(element) &&
            std::any_of(element.nodes.begin(),
                        element.nodes.end(),
                        [&](const unsigned int n) { return own[n]; }))
          for (const int tag : file.groups[element.group])
            names.insert(name_of(file.volume_names, tag));
      return {names.begin(), names.end()};
    }



    BodyMesh
    GmshBody::make()
    {
      check_physical_volume();
      check_kinds();
      collect_hexahedra();
      orient_hexahedra();
      find_boundary();
      check_connected();
      name_boundary();
      number_unnamed_faces();
      BodyMesh mesh         = without_unused_nodes();
      mesh.touching_volumes = touching_volumes();
      dealii::GridTools::consistently_order_cells(mesh.cells);
      return mesh;
    }
  } // namespace



  BodyMesh
  read_gmsh_body(const BodyParameters &body)
  {
    if (body.mesh_file.empty())
      throw InputError("Scene/Body " + body.name +
                       "/Mesh file: is empty: name the Gmsh file of the body");
    return GmshBody(body).make();
  }
} // namespace squeal
