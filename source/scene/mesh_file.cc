// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/unknown_choice.h>

#include <squeal/scene/mesh_file.h>

namespace squeal
{
  namespace
  {
    MeshFile
    read_in_units_of_file(const BodyParameters &body)
    {
      switch (body.shape)
        {
        case BodyParameters::Shape::gmsh:
          return read_gmsh_file(body.mesh_file);
        case BodyParameters::Shape::abaqus:
          return read_abaqus_mesh(body.mesh_file, body.mesh_faces);
        case BodyParameters::Shape::nastran:
          return read_nastran_mesh(body.mesh_file, body.mesh_faces);
        case BodyParameters::Shape::annulus:
        case BodyParameters::Shape::block:
        case BodyParameters::Shape::cylinder:
        case BodyParameters::Shape::layer:
        case BodyParameters::Shape::rigid:
          break;
        }
      unknown_choice("shape with a mesh file");
    }
  } // namespace



  MeshGroups::MeshGroups(MeshFile &f)
    : file(f)
  {
  }

  int
  MeshGroups::surface(const std::string &name)
  {
    const int tag = surfaces.emplace(name, 1 + surfaces.size()).first->second;
    file.surface_names[tag] = name;
    return tag;
  }

  int
  MeshGroups::volume(const std::string &name)
  {
    const int tag = volumes.emplace(name, 1 + volumes.size()).first->second;
    file.volume_names[tag] = name;
    return tag;
  }

  unsigned int
  MeshGroups::of(const std::vector<int> &tags)
  {
    const auto [it, is_new] = known.emplace(tags, file.groups.size());
    if (is_new)
      file.groups.push_back(tags);
    return it->second;
  }



  MeshFile
  read_mesh_file(const BodyParameters &body)
  {
    MeshFile file = read_in_units_of_file(body);
    if (body.mesh_length_unit != 1.)
      for (auto &x : file.nodes)
        x *= body.mesh_length_unit;
    return file;
  }
} // namespace squeal
