// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/unknown_choice.h>

#include <squeal/scene/mesh_selection.h>

#include <algorithm>
#include <optional>
#include <set>

namespace squeal
{
  namespace
  {
    using Kind = MeshFile::Kind;

    bool
    is_volume(const Kind kind)
    {
      return kind != Kind::low_dimensional && kind != Kind::quadrilateral &&
             kind != Kind::other_surface;
    }

    /** What formats call a group of volumes. */
    std::string
    word_for_volume(const BodyParameters &body)
    {
      switch (body.shape)
        {
        case BodyParameters::Shape::gmsh:
          return "physical volume";
        case BodyParameters::Shape::abaqus:
          return "element set";
        case BodyParameters::Shape::nastran:
          return "property or set";
        case BodyParameters::Shape::annulus:
        case BodyParameters::Shape::block:
        case BodyParameters::Shape::cylinder:
        case BodyParameters::Shape::layer:
        case BodyParameters::Shape::rigid:
          break;
        }
      unknown_choice("shape with a mesh file");
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
          return "hexahedra of third or higher order";
        case Kind::fluid:
          return "cells of a fluid";
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
  } // namespace



  /** The name of a physical group, or its number where it has none. */
  std::string
  name_of_group(const std::map<int, std::string> &names, const int tag)
  {
    const auto it = names.find(tag);
    return it == names.end() ? std::to_string(tag) : it->second;
  }

  std::string
  two_meanings_of(const std::string                &word,
                  const std::map<int, std::string> &names,
                  const std::set<int>              &tags,
                  const std::string                &kind)
  {
    std::vector<int> named, numbered;
    for (const int tag : tags)
      if (name_of_group(names, tag) == word)
        (names.count(tag) > 0 ? named : numbered).push_back(tag);
    const std::string named_so = "a " + kind + " of the name '" + word + "'";
    if (named.size() > 1)
      return named_so + " twice, with the numbers " + std::to_string(named[0]) +
             " and " + std::to_string(named[1]) +
             ": give each a name of its own";
    if (!named.empty() && !numbered.empty())
      return named_so +
             " and another of this number without a name: name it, too";
    return "";
  }

  MeshSelection::MeshSelection(const MeshFile &file, const BodyParameters &body)
    : file(file)
    , body(body)
  {
    check_physical_volume();
    check_kinds();
  }

  void
  MeshSelection::fail(const std::string &text) const
  {
    throw InputError("body '" + body.name + "': mesh file '" + body.mesh_file +
                     "' " + text);
  }

  bool
  MeshSelection::holds(const MeshFile::Element &element) const
  {
    if (!is_volume(element.kind))
      return false;
    if (body.physical_volume.empty())
      return true;
    const auto &group = file.groups[element.group];
    return std::any_of(group.begin(), group.end(), [&](const int tag) {
      return name_of_group(file.volume_names, tag) == body.physical_volume;
    });
  }



  void
  MeshSelection::check_physical_volume() const
  {
    if (body.physical_volume.empty())
      return;
    std::set<std::string> names;
    for (const auto &[tag, name] : file.volume_names)
      names.insert(name);
    std::set<int> tags;
    for (const auto &element : file.elements)
      if (is_volume(element.kind))
        for (const int tag : file.groups[element.group])
          tags.insert(tag);
    for (const int tag : tags)
      names.insert(name_of_group(file.volume_names, tag));
    if (const std::string two = two_meanings_of(
          body.physical_volume, file.volume_names, tags, word_for_volume(body));
        !two.empty())
      fail("has " + two);
    if (names.count(body.physical_volume) > 0)
      return;
    std::string list;
    for (const auto &name : names)
      list += (list.empty() ? "" : ", ") + name;
    fail("has no " + word_for_volume(body) + " '" + body.physical_volume +
         "'; there are: " + (list.empty() ? "none" : list));
  }



  void
  MeshSelection::check_kinds() const
  {
    std::map<Kind, unsigned int> count;
    for (const auto &element : file.elements)
      if (holds(element))
        ++count[element.kind];
    if (count.empty())
      fail(
        (body.physical_volume.empty()
           ? "holds no volume cells"
           : "holds no cells of " + word_for_volume(body) + " '" +
               body.physical_volume + "'") +
        std::string(body.shape == BodyParameters::Shape::gmsh
                      ? ": mesh it in three dimensions and give the volume a "
                        "physical group"
                      : ": hexahedra are needed"));
    std::string others;
    for (const auto &[kind, n] : count)
      if (kind != Kind::hexahedron)
        others += (others.empty() ? "" : ", ") + plural_of(kind) + " (" +
                  std::to_string(n) + ")";
    const bool only_order = count.count(Kind::higher_order_hexahedron) == 1 &&
                            count.size() <= 1 + count.count(Kind::hexahedron);
    if (count.count(Kind::fluid) > 0)
      fail("holds " + others +
           ", but bodies are solid: leave what is filled with a fluid out "
           "(PSOLID, FCTN)");
    if (!others.empty())
      fail("holds " + others +
           ", but only hexahedra with 8, 20 or 27 nodes are used: " +
           (body.shape != BodyParameters::Shape::gmsh
              ? "mesh the part with hexahedra (swept, or by partitions)"
            : only_order ? "save it with Mesh.ElementOrder = 2 (the degree is "
                           "set in Discretization)"
                         : "use transfinite or extruded meshes with Recombine, "
                           "or Mesh.SubdivisionAlgorithm = 2"));
  }



  int
  MeshSelection::material() const
  {
    std::optional<int> found;
    for (const auto &element : file.elements)
      if (holds(element))
        {
          if (found && *found != element.material)
            fail("gives the cells of the body several materials: make a body "
                 "of each, joined by ties");
          found = element.material;
        }
    return found.value_or(-1);
  }



  std::vector<std::string>
  MeshSelection::touching_volumes() const
  {
    std::vector<bool> own(file.nodes.size(), false);
    for (const auto &element : file.elements)
      if (holds(element))
        for (const unsigned int n : element.nodes)
          own[n] = true;
    std::set<std::string> names;
    for (const auto &element : file.elements)
      if (element.kind == Kind::hexahedron && !holds(element) &&
          std::any_of(element.nodes.begin(),
                      element.nodes.end(),
                      [&](const unsigned int n) { return own[n]; }))
        for (const int tag : file.groups[element.group])
          names.insert(name_of_group(file.volume_names, tag));
    return {names.begin(), names.end()};
  }
} // namespace squeal
