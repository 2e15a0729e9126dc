// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nastran_reader.h"

#include <squeal/base/exceptions.h>

#include <squeal/parameters/text.h>

#include <squeal/scene/mesh_cell.h>

#include <algorithm>

// Bodies and faces of a Nastran mesh from its properties, sets, skins and
// loads.

namespace squeal
{
  using Kind = MeshFile::Kind;

  void
  NastranReader::place_hexahedron(const Cell &cell)
  {
    auto                     &element = file.elements[cell.position];
    std::vector<unsigned int> nodes;
    const bool                is_linear = std::all_of(cell.points.begin() + 8,
                                       cell.points.end(),
                                       [](const long p) { return p == 0; });
    for (unsigned int i = 0; i < (is_linear ? 8 : 20); ++i)
      if (cell.points[i] != 0 || i < 8)
        nodes.push_back(point(cell.points[i], cell.line));
      else
        {
          // An edge without its middle point is straight.
          const auto ends = ends_of_nastran_edge(i);
          nodes.push_back(file.nodes.size());
          file.nodes.push_back(
            file.nodes[nodes[ends[0]]] +
            .5 * (file.nodes[nodes[ends[1]]] - file.nodes[nodes[ends[0]]]));
        }
    element.nodes = in_gmsh_order(nodes, NodeOrder::nastran);
  }

  void
  NastranReader::number_points()
  {
    for (const Cell &cell : cells)
      {
        auto &element = file.elements[cell.position];
        if (element.kind == Kind::hexahedron)
          place_hexahedron(cell);
        else if (element.kind == Kind::quadrilateral)
          for (const long p : cell.points)
            element.nodes.push_back(point(p, cell.line));
      }
  }

  void
  NastranReader::group_cells()
  {
    std::map<long, std::vector<int>> sets_of_element;
    for (const auto &[number, ranges] : cell_sets)
      for (const auto &cell : file.elements)
        if (std::any_of(ranges.begin(), ranges.end(), [&](const auto &r) {
              return r[0] <= cell.tag && cell.tag <= r[1];
            }))
          sets_of_element[cell.tag].push_back(
            groups.volume("set " + std::to_string(number)));
    for (const Cell &cell : cells)
      {
        auto      &element  = file.elements[cell.position];
        const bool is_skin  = element.kind == Kind::quadrilateral;
        const auto property = std::to_string(cell.property);
        if (is_skin && !wanted.empty() && wanted.count(property) == 0)
          {
            element.kind = Kind::other_surface;
            element.nodes.clear();
          }
        std::vector<int> tags;
        if (element.kind == Kind::quadrilateral)
          tags = {groups.surface(property)};
        else if (element.kind != Kind::other_surface)
          {
            tags = sets_of_element[element.tag];
            tags.push_back(groups.volume(property));
            const auto section = sections.find(cell.property);
            if (section != sections.end())
              {
                if (section->second.is_fluid)
                  element.kind = Kind::fluid;
                const auto material = materials.find(section->second.material);
                if (material != materials.end())
                  element.material = material->second;
              }
          }
        element.group = groups.of(tags);
      }
  }



  void
  NastranReader::add_face_of(const Load &load)
  {
    const auto found = cell_of_element.find(load.element);
    if (found == cell_of_element.end())
      text.fail_at(load.line,
                   "element " + std::to_string(load.element) +
                     " is not in the file");
    const auto &element = file.elements[cells[found->second].position];
    if (element.kind != Kind::hexahedron ||
        (!wanted.empty() && wanted.count(load.name) == 0))
      return;
    const unsigned int a = point(load.corner, load.line),
                       b = point(load.opposite, load.line);
    for (const auto &corners : faces_of_gmsh_cell())
      {
        std::vector<unsigned int> nodes;
        for (const unsigned int c : corners)
          nodes.push_back(element.nodes[c]);
        if ((nodes[0] == a && nodes[2] == b) ||
            (nodes[2] == a && nodes[0] == b) ||
            (nodes[1] == a && nodes[3] == b) ||
            (nodes[3] == a && nodes[1] == b))
          {
            file.elements.push_back({load.element,
                                     Kind::quadrilateral,
                                     groups.of({groups.surface(load.name)}),
                                     nodes,
                                     -1});
            return;
          }
      }
    text.fail_at(load.line,
                 "PLOAD4: grid points " + std::to_string(load.corner) +
                   " and " + std::to_string(load.opposite) +
                   " are no opposite corners of a face of element " +
                   std::to_string(load.element));
  }

  void
  NastranReader::add_point_sets()
  {
    for (const auto &[number, ranges] : point_sets)
      {
        const std::string name = "set " + std::to_string(number);
        if (wanted.count(name) == 0)
          continue;
        std::vector<bool> holds(file.nodes.size(), false);
        for (const auto &[point_number, index] : index_of_point)
          for (const auto &range : ranges)
            if (range[0] <= point_number && point_number <= range[1])
              holds[index] = true;
        add_faces_of_nodes(file, holds, groups.of({groups.surface(name)}));
      }
  }

  void
  NastranReader::finish()
  {
    if (file.nodes.empty() || cells.empty())
      throw InputError(text.name() + " is no mesh or truncated: it has no " +
                       (file.nodes.empty() ? "GRID" : "elements"));
    number_points();
    group_cells();
    for (const Load &load : loads)
      add_face_of(load);
    add_point_sets();
    finish_materials();
  }
} // namespace squeal
