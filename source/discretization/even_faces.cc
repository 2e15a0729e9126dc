// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/discretization/even_faces.h>
#include <squeal/scene/coarse_mesh.h>

namespace squeal
{
  std::vector<unsigned int>
  even_faces(const Discretization &d)
  {
    const auto               &scene = d.scene();
    const CoarseMesh         &mesh  = d.coarse_mesh();
    std::vector<unsigned int> faces;
    for (const auto &contact : scene.contacts)
      if (contact.formulation != ContactParameters::Formulation::springs)
        faces.push_back(
          face_id(mesh, scene, contact.source_body, contact.source_face));
    for (std::size_t i = 0; i < scene.ties.size(); ++i)
      if (!mesh.tie_is_conforming[i])
        faces.push_back(face_id(
          mesh, scene, scene.ties[i].source_body, scene.ties[i].source_face));
    return faces;
  }
} // namespace squeal
