// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/parameters/checks.h>
#include <squeal/parameters/numbers.h>
#include <squeal/parameters/text.h>

namespace squeal
{
  namespace prm
  {
    void
    check_damping_in_time(const SceneParameters &scene)
    {
      // That of parts counts with that model alone, and is refused elsewhere.
      const auto require_viscous = [](const std::string &section,
                                      const double       loss_factor) {
        if (loss_factor != 0.)
          refuse_entry(section,
                       "Structural damping",
                       "= " + format_number(loss_factor) +
                         ": a loss factor has no motion in time; damping there "
                         "is viscous: take 'Stiffness damping', which has the "
                         "loss factor (2 pi frequency) times that");
      };
      require_viscous("Scene/Damping", scene.damping.structural_damping);
      for (const BodyParameters &body : scene.bodies)
        require_viscous("Scene/Body " + body.name, body.structural_damping);
      for (const SpringParameters &spring : scene.springs)
        require_viscous("Scene/Spring " + spring.name,
                        spring.structural_damping);
      for (const ContactParameters &contact : scene.contacts)
        {
          const std::string section = "Scene/Contact " + contact.name;
          require_viscous(section, contact.structural_damping);
          if (contact.stiffness_damping != 0.)
            refuse_entry(section,
                         "Stiffness damping",
                         "must be 0: contact opens, closes and slides in time "
                         "without damping of its own");
        }
    }



    void
    check_turning_in_time(const SceneParameters &scene)
    {
      for (const BodyParameters &body : scene.bodies)
        if (body.rotation_speed != 0.)
          refuse_entry(
            "Scene/Body " + body.name,
            "Rotation speed",
            "= " + format_number(body.rotation_speed) +
              ": steady sliding, which 'Contact state = preload' takes its "
              "contact from, and motions in time have no gyroscopic and "
              "centrifugal forces; set it to 0, as they slide by 'Sliding "
              "speed' of the contact, or for eigenvalues 'Contact state = "
              "full'");
    }
  } // namespace prm
} // namespace squeal
