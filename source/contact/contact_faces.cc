// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/number_text.h>
#include <squeal/contact/contact_faces.h>
#include <squeal/contact/turning_sense.h>
#include <squeal/discretization/face_quadrature.h>

namespace squeal
{
  namespace
  {
    /** Of faces whose coordinates are rounded in a mesh file. */
    constexpr double normal_tolerance = 1e-3;
  } // namespace



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
  }



  void
  require_upward(const ContactParameters &contact, const ContactGeometry &g)
  {
    for (const ContactFrame &frame : g.frames)
      {
        const auto &n = frame.normal;
        if (!(std::hypot(n[0], n[1], n[2] - 1.) <= normal_tolerance))
          throw InputError(
            "contact " + contact.name + ": the target face '" +
            contact.target_face + "' of body '" + contact.target_body +
            "' has the outward normal (" + rounded_text(n[0], 3) + ", " +
            rounded_text(n[1], 3) + ", " + rounded_text(n[2], 3) +
            "): steady sliding and transients are for target faces that look "
            "along +z; turn the scene until the target lies flat under its "
            "source, or analyse it with 'Contact state = full'");
      }
  }
} // namespace squeal
