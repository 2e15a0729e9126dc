// SPDX-License-Identifier: LGPL-2.1-or-later

// Meshes of Abaqus input files and Nastran bulk data: READER is the function,
// FILE_NAME what the file is called.
#include <squeal/scene/mesh_file.h>

#include "fuzz.h"

using namespace squeal;

extern "C" int
LLVMFuzzerTestOneInput(const std::uint8_t *data, const std::size_t size)
{
  return fuzz::read_as(FILE_NAME, data, size, [](const std::string &path) {
    const MeshFile file = READER(path, {"set 1", "floor", "7"});
    for (const auto &node : file.nodes)
      for (unsigned int c = 0; c < 3; ++c)
        fuzz::require_finite(node[c], "a coordinate");
    for (const MeshFile::Element &element : file.elements)
      {
        fuzz::require(element.group < file.groups.size(), "a group is missing");
        fuzz::require(element.material <
                        static_cast<int>(file.materials.size()),
                      "a material is missing");
        if (element.kind == MeshFile::Kind::hexahedron)
          fuzz::require(element.nodes.size() == 8 ||
                          element.nodes.size() == 20 ||
                          element.nodes.size() == 27,
                        "a hexahedron has too few nodes");
        for (const unsigned int node : element.nodes)
          fuzz::require(node < file.nodes.size(), "a node is missing");
      }
  });
}
