// SPDX-License-Identifier: LGPL-2.1-or-later

// Gmsh meshes, versions 2.2 and 4.1.
#include <squeal/scene/mesh_file.h>

#include "fuzz.h"

using namespace squeal;

extern "C" int
LLVMFuzzerTestOneInput(const std::uint8_t *data, const std::size_t size)
{
  return fuzz::read_as("in.msh", data, size, [](const std::string &path) {
    const MeshFile file = read_gmsh_file(path);
    for (const auto &node : file.nodes)
      for (unsigned int c = 0; c < 3; ++c)
        fuzz::require_finite(node[c], "a coordinate");
    for (const MeshFile::Element &element : file.elements)
      {
        fuzz::require(element.group < file.groups.size(), "a group is missing");
        if (element.kind == MeshFile::Kind::hexahedron)
          for (const unsigned int node : element.nodes)
            fuzz::require(node < file.nodes.size(), "a node is missing");
      }
  });
}
