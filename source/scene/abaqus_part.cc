// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/scene/abaqus_part.h>
#include <squeal/scene/import_text.h>
#include <squeal/scene/mesh_cell.h>

#include <cmath>

namespace squeal
{
  namespace
  {
    using dealii::Point;
    using dealii::Tensor;

    template <typename Named>
    Named &
    add_named(std::map<std::string, Named> &all, const std::string &name)
    {
      Named &result = all[import::upper_case(name)];
      if (result.name.empty())
        result.name = name;
      return result;
    }



    /** The name under which a set or surface is asked for; empty: it is not. */
    std::string
    asked_name(const std::vector<std::string> &wanted, const std::string &name)
    {
      for (const std::string &other : wanted)
        if (import::upper_case(other) == import::upper_case(name))
          return other;
      return "";
    }

    void
    add_faces(const AbaqusPart::Surface &surface,
              const unsigned int         group,
              MeshFile                  &file)
    {
      for (const auto &[element, face] : surface.faces)
        for (unsigned int f = face < 6 ? face : 0; f < 6; ++f)
          {
            const MeshFile::Element cell = file.elements[element];
            if (cell.kind != MeshFile::Kind::hexahedron)
              break;
            std::vector<unsigned int> nodes;
            for (const unsigned int c : faces_of_gmsh_cell()[f])
              nodes.push_back(cell.nodes[c]);
            file.elements.push_back(
              {cell.tag, MeshFile::Kind::quadrilateral, group, nodes, -1});
            if (face < 6)
              break;
          }
    }

    void
    add_faces_of_set(const std::vector<unsigned int> &nodes,
                     const unsigned int               group,
                     MeshFile                        &file)
    {
      std::vector<bool> holds(file.nodes.size(), false);
      for (const unsigned int n : nodes)
        holds[n] = true;
      add_faces_of_nodes(file, holds, group);
    }
  } // namespace



  void
  add_instance(AbaqusPart        &assembly,
               const AbaqusPart  &part,
               const std::string &name)
  {
    const unsigned int first_node    = assembly.points.size(),
                       first_element = assembly.elements.size();
    const std::string prefix         = name + ".";
    assembly.points.insert(
      assembly.points.end(), part.points.begin(), part.points.end());
    auto &all = add_named(assembly.element_sets, name);
    for (auto element : part.elements)
      {
        for (unsigned int &n : element.nodes)
          n += first_node;
        all.members.push_back(assembly.elements.size());
        assembly.elements.push_back(std::move(element));
      }
    const auto add_sets = [&](const auto &from, auto &to, unsigned int first) {
      for (const auto &[key, set] : from)
        for (const unsigned int member : set.members)
          add_named(to, prefix + set.name).members.push_back(first + member);
    };
    add_sets(part.node_sets, assembly.node_sets, first_node);
    add_sets(part.element_sets, assembly.element_sets, first_element);
    for (const auto &[key, surface] : part.surfaces)
      {
        auto &copy = add_named(assembly.surfaces, prefix + surface.name);
        for (const auto &face : surface.faces)
          copy.faces.push_back({{first_element + face[0], face[1]}});
        for (const unsigned int node : surface.nodes)
          copy.nodes.push_back(first_node + node);
      }
    for (auto section : part.sections)
      {
        for (unsigned int &element : section.elements)
          element += first_element;
        assembly.sections.push_back(std::move(section));
      }
  }



  void
  place_instance(AbaqusPart &part, const InstancePlace &place)
  {
    const auto        &turn = place.turn;
    const Point<3>     a(turn[0], turn[1], turn[2]);
    const Tensor<1, 3> axis  = Point<3>(turn[3], turn[4], turn[5]) - a;
    const double       angle = turn[6] * (M_PI / 180.);
    for (auto &x : part.points)
      {
        x += place.shift;
        if (angle == 0.)
          continue;
        const Tensor<1, 3> e = axis / axis.norm(), r = x - a,
                           along = (e * r) * e;
        x                        = a + along + std::cos(angle) * (r - along) +
            std::sin(angle) * dealii::cross_product_3d(e, r);
      }
  }



  void
  add_to_mesh(const AbaqusPart                 &model,
              const std::vector<std::string>   &wanted,
              const std::map<std::string, int> &material,
              MeshFile                         &file)
  {
    file.nodes    = model.points;
    file.elements = model.elements;
    MeshGroups                    groups(file);
    std::vector<std::vector<int>> tags(file.elements.size());
    for (const auto &[key, set] : model.element_sets)
      {
        const int tag = groups.volume(set.name);
        for (const unsigned int element : set.members)
          if (tags[element].empty() || tags[element].back() != tag)
            tags[element].push_back(tag);
      }
    for (std::size_t e = 0; e < tags.size(); ++e)
      file.elements[e].group = groups.of(tags[e]);
    for (const auto &section : model.sections)
      for (const unsigned int element : section.elements)
        if (const auto it = material.find(section.material);
            it != material.end())
          file.elements[element].material = it->second;

    for (const auto &[key, surface] : model.surfaces)
      {
        const std::string name =
          wanted.empty() ? surface.name : asked_name(wanted, surface.name);
        if (name.empty())
          continue;
        const unsigned int group = groups.of({groups.surface(name)});
        add_faces(surface, group, file);
        if (!surface.nodes.empty())
          add_faces_of_set(surface.nodes, group, file);
      }
    for (const auto &[key, set] : model.node_sets)
      if (const std::string name = asked_name(wanted, set.name);
          !name.empty() && model.surfaces.count(key) == 0)
        add_faces_of_set(set.members, groups.of({groups.surface(name)}), file);
  }
} // namespace squeal
