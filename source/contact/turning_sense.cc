// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/number_text.h>
#include <squeal/contact/friction_law.h>
#include <squeal/contact/turning_sense.h>
#include <squeal/scene/coarse_mesh.h>
#include <squeal/scene/turning.h>

#include <cmath>

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

    /** Largest difference of the sliding speed from that of turning, relative:
     * what a coarse mesh or a rounded number may make it. */
    constexpr double speed_tolerance = 0.1;

    /** The terms of the slip rate go by `Sliding speed`, not by the turning.
     * @param turning  mean speed of the target along the source, m/s */
    void
    require_speed_of_turning(const ContactParameters &contact,
                             const double             turning)
    {
      if (turning == 0. || contact.state == ContactParameters::State::stick ||
          !has_slip_rate_terms(contact) ||
          std::abs(contact.sliding_speed - turning) <=
            speed_tolerance * turning)
        return;
      throw InputError(
        "'Scene/Contact " + contact.name +
        "/Sliding speed' = " + rounded_text(contact.sliding_speed, 4) +
        " m/s, but by its 'Rotation speed' the body '" + contact.target_body +
        "' moves along '" + contact.source_body + "' with " +
        rounded_text(turning, 4) +
        " m/s in the mean, and the pair has terms of the slip rate: the two "
        "may differ by " +
        rounded_text(100. * speed_tolerance, 2) + " %");
    }
  } // namespace



  void
  require_sliding_as_turning(const SceneParameters               &scene,
                             const ContactParameters             &contact,
                             const std::vector<dealii::Point<3>> &points,
                             const std::vector<ContactFrame>     &frames)
  {
    // Of a law the sign alone is the coefficient's; zero is no backward
    // turning.
    const double sense = FrictionLaw(contact).is_frictionless() ? 0.
                         : contact.friction_coefficient < 0.    ? -1.
                                                                : 1.;
    double       mean  = 0.;
    for (std::size_t i = 0; i < points.size(); ++i)
      {
        const Vector velocity =
          turning_velocity(scene, contact.target_body, points[i]) -
          turning_velocity(scene, contact.source_body, points[i]);
        mean += velocity.norm() / points.size();
        if (sense * (velocity * frames[i].sliding) >= 0.)
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
    require_speed_of_turning(contact, mean);
  }
} // namespace squeal
