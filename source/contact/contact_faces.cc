// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/contact/contact_faces.h>
#include <squeal/contact/face_coverage.h>
#include <squeal/contact/turning_sense.h>
#include <squeal/discretization/face_quadrature.h>

namespace squeal
{
  void
  check_contact_faces(const Discretization &d)
  {
    const auto &scene = d.scene();
    for (const auto &contact : scene.contacts)
      {
        const unsigned int body = body_index(scene, contact.source_body);
        if (scene.bodies[body].shape == BodyParameters::Shape::rigid)
          continue;
        const FaceQuadrature face = face_quadrature(
          d,
          face_id(
            d.coarse_mesh(), scene, contact.source_body, contact.source_face));
        if (face.points.empty())
          throw InputError("contact " + contact.name + ": the source face '" +
                           contact.source_face + "' of body '" +
                           contact.source_body +
                           "' is empty: a tie has taken it, or no cell of the "
                           "body has it");
        const ContactFrames all =
          contact_frames(d, contact, face.points, face.normals);
        require_sliding_as_turning(scene, contact, face.points, all.frames);
      }
    check_faces_covered(d);
  }
} // namespace squeal
