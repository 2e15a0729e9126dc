// SPDX-License-Identifier: LGPL-2.1-or-later
#include "abaqus_reader.h"

#include <squeal/scene/mesh_cell.h>

// Nodes and elements of an Abaqus input file.

namespace squeal
{
  using import::upper_case;

  namespace
  {
    using Kind = MeshFile::Kind;

    bool
    begins(const std::string &text, const char *start)
    {
      return text.compare(0, std::string(start).size(), start) == 0;
    }

    /** The kind of an element type and how many nodes are read of it. */
    std::pair<Kind, unsigned int>
    kind_of(const std::string &type)
    {
      static const std::vector<std::pair<const char *, std::pair<Kind, int>>>
        types{{"C3D8", {Kind::hexahedron, 8}},
              {"C3D20", {Kind::hexahedron, 20}},
              {"C3D27", {Kind::hexahedron, 27}},
              {"C3D4", {Kind::tetrahedron, 0}},
              {"C3D10", {Kind::tetrahedron, 0}},
              {"C3D6", {Kind::wedge, 0}},
              {"C3D15", {Kind::wedge, 0}},
              {"C3D5", {Kind::pyramid, 0}},
              {"C3D13", {Kind::pyramid, 0}}};
      for (const auto &[name, kind] : types)
        if (begins(type, name) &&
            type.find_first_of("0123456789", std::string(name).size()) ==
              std::string::npos)
          return kind;
      for (const char *name : {"S", "M3D", "STRI", "R3D", "DS", "DSAX"})
        // continuum shells, SC8R, are volumes
        if (begins(type, name) && !begins(type, "SPRING") &&
            !begins(type, "SC"))
          return {Kind::other_surface, 0};
      for (const char *name : {"B2",
                               "B3",
                               "T2D",
                               "T3D",
                               "SPRING",
                               "DASHPOT",
                               "MASS",
                               "ROTARYI",
                               "CONN",
                               "GAP",
                               "DCOUP",
                               "HEATCAP",
                               "RB3D",
                               "PIPE",
                               "FRAME"})
        if (begins(type, name))
          return {Kind::low_dimensional, 0};
      return {Kind::other_volume, 0};
    }
  } // namespace



  void
  AbaqusReader::read_nodes()
  {
    if (const auto system = option("SYSTEM");
        !system.empty() && upper_case(system) != "R")
      text.fail_at(keyword.line,
                   "*NODE, SYSTEM=" + system +
                     " is not read: write the nodes in x, y, z");
    AbaqusPart::Set *set = nullptr;
    if (const auto name = option("NSET"); !name.empty())
      {
        set = &current->node_sets[upper_case(name)];
        if (set->name.empty())
          set->name = name;
      }
    while (next_data())
      {
        const long number = integer(0, "node number");
        if (!current->number_of_node.emplace(number, current->points.size())
               .second)
          text.fail("node " + std::to_string(number) + " is there twice");
        if (set)
          set->members.push_back(current->points.size());
        current->points.emplace_back(
          real(1, "coordinate"), real(2, "coordinate"), real(3, "coordinate"));
      }
  }

  void
  AbaqusReader::read_elements()
  {
    const std::string type     = upper_case(needed("TYPE"));
    const auto [kind, n_nodes] = kind_of(type);
    AbaqusPart::Set *set       = nullptr;
    if (const auto name = option("ELSET"); !name.empty())
      {
        set = &current->element_sets[upper_case(name)];
        if (set->name.empty())
          set->name = name;
      }
    while (next_data())
      read_element(type, kind, n_nodes, set);
  }

  void
  AbaqusReader::read_element(const std::string   &type,
                             const MeshFile::Kind kind,
                             const unsigned int   n_nodes,
                             AbaqusPart::Set     *set)
  {
    const long        number = integer(0, "element number");
    std::vector<long> numbers;
    std::size_t       first = 1;
    do
      {
        for (std::size_t i = first; i < fields.size(); ++i)
          numbers.push_back(integer(i, "node number"));
        first = 0;
      }
    while ((numbers.size() < n_nodes || (ends_with_comma && n_nodes == 0)) &&
           next_data());
    MeshFile::Element element{number, kind, 0, {}, -1};
    if (n_nodes > 0 && numbers.size() != n_nodes)
      text.fail("element " + std::to_string(number) + " of type " + type +
                " has " + std::to_string(numbers.size()) +
                " nodes instead of " + std::to_string(n_nodes));
    std::vector<unsigned int> nodes;
    for (std::size_t i = 0; i < n_nodes; ++i)
      {
        const auto it = current->number_of_node.find(numbers[i]);
        if (it == current->number_of_node.end())
          text.fail("element " + std::to_string(number) + " refers to node " +
                    std::to_string(numbers[i]) +
                    ", which is not in the file above");
        nodes.push_back(it->second);
      }
    element.nodes = in_gmsh_order(nodes, NodeOrder::abaqus);
    if (!current->number_of_element.emplace(number, current->elements.size())
           .second)
      text.fail("element " + std::to_string(number) + " is there twice");
    if (set)
      set->members.push_back(current->elements.size());
    current->elements.push_back(std::move(element));
  }
} // namespace squeal
