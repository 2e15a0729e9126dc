// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/number_text.h>
#include <squeal/contact/turning_sense.h>
#include <squeal/scene/coarse_mesh.h>
#include <squeal/scene/turning.h>

namespace squeal
{
  namespace
  {
    using Vector = dealii::Tensor<1, 3>;

    /** Of the material of a body at @p x, m/s. */
    Vector
    turning_velocity(const SceneParameters  &scene,
                     const std::string      &name,
                     const dealii::Point<3> &x)
    {
      Vector velocity;
      if (name == "ground")
        return velocity;
      const auto    &body   = carrier_of(scene, body_index(scene, name));
      const Vector3 &centre = body.centre_of_rotation();
      velocity[0]           = -body.rotation_speed * (x[1] - centre[1]);
      velocity[1]           = body.rotation_speed * (x[0] - centre[0]);
      return velocity;
    }
  } // namespace



  void
  require_sliding_as_turning(const SceneParameters               &scene,
                             const ContactParameters             &contact,
                             const std::vector<dealii::Point<3>> &points,
                             const std::vector<ContactFrame>     &frames)
  {
    for (std::size_t i = 0; i < points.size(); ++i)
      {
        const Vector velocity =
          turning_velocity(scene, contact.target_body, points[i]) -
          turning_velocity(scene, contact.source_body, points[i]);
        if (velocity * frames[i].sliding * contact.friction_coefficient >= 0.)
          continue;
        throw InputError(
          "contact " + contact.name + ": by its 'Rotation speed' the body '" +
          contact.target_body + "' moves along '" + contact.source_body +
          "' with (" + rounded_text(velocity[0], 4) + ", " +
          rounded_text(velocity[1], 4) +
          ", 0) m/s, but it slides the other way by 'Friction direction', "
          "'Rotation axis' and the sign of 'Friction coefficient': reverse one "
          "of them");
      }
  }
} // namespace squeal
