// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_scene_matching_faces_h
#define squeal_scene_matching_faces_h

#include <squeal/scene/coarse_mesh.h>

#include <map>

namespace squeal
{
  /**
   * Partner on the face @p target of every vertex of the face @p source, both by
   * their boundary ids; empty where the meshes of the two differ: in their
   * vertices, in what vertices a quad has, or in the nodes between the corners,
   * where cells of second order are curved. Differences below 1e-6 of the
   * largest extent of the source count as none.
   */
  std::map<unsigned int, unsigned int> matching_vertices(
    const CoarseMesh  &mesh,
    const unsigned int source,
    const unsigned int target);
} // namespace squeal

#endif
