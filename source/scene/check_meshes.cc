// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/scene/check_meshes.h>
#include <squeal/scene/coarse_mesh.h>

namespace squeal
{
  void
  check_meshes(const SceneParameters &scene)
  {
    if (scene.kind != SceneParameters::Kind::bodies)
      return;
    const CoarseMesh mesh = make_coarse_mesh(scene);
    const auto check = [&](const std::string &body, const std::string &face) {
      if (!face.empty() && body != "ground" &&
          scene.bodies[body_index(scene, body)].shape !=
            BodyParameters::Shape::rigid)
        face_id(mesh, scene, body, face);
    };
    for (const auto &contact : scene.contacts)
      {
        check(contact.source_body, contact.source_face);
        check(contact.target_body, contact.target_face);
      }
    for (const auto &support : scene.supports)
      check(support.body, support.face);
    for (const auto &load : scene.loads)
      check(load.body, load.face);
    for (const auto &spring : scene.springs)
      if (spring.kind == SpringParameters::Kind::area)
        check(spring.body, spring.face);
  }
} // namespace squeal
