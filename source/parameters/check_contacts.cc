// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>

#include <squeal/parameters/checks.h>
#include <squeal/parameters/face_geometry.h>
#include <squeal/parameters/numbers.h>
#include <squeal/parameters/text.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace squeal
{
  namespace prm
  {
    namespace
    {
      using Shape = BodyParameters::Shape;

      [[noreturn]] void
      refuse_pair(const ContactParameters &contact, const std::string &reason)
      {
        throw InputError("contact " + contact.name +
                         ": faces do not meet: " + reason + "; change 'Scene/" +
                         "Body " + contact.source_body +
                         "/Position' or the sizes of the bodies");
      }



      void
      check_sliding_direction(const ContactParameters &contact,
                              const std::string       &section)
      {
        using Direction    = ContactParameters::FrictionDirection;
        const auto &given  = contact.sliding_direction;
        const bool  is_set = given != ContactParameters().sliding_direction;
        if (is_set && contact.friction_direction != Direction::given)
          refuse_entry(section,
                       "Sliding direction",
                       "is for 'Friction direction = given'");
        if (!(std::hypot(given[0], given[1], given[2]) > 0.))
          refuse_entry(section, "Sliding direction", "must not be 0, 0, 0");
      }

      /** Of flat faces of squeal's own shapes; others are judged when the mesh
       * is there. A sliding direction that is not along them is no sliding. */
      void
      require_sliding_along(const BodyParameters    &target,
                            const ContactParameters &contact,
                            const std::string       &section)
      {
        const auto face = flat_face(target, contact.target_face);
        if (face && face->axis == 1 &&
            contact.friction_direction ==
              ContactParameters::FrictionDirection::fixed_y)
          refuse_entry(section,
                       "Friction direction",
                       "= fixed y is across the target face, which looks along "
                       "y: set slip, or given with a 'Sliding direction'");
      }



      void
      check_faces(const SceneParameters   &scene,
                  const ContactParameters &contact,
                  const std::string       &section)
      {
        const BodyParameters &source =
          require_body(scene, contact.source_body, section, "Source body");
        require_face(source, contact.source_face, section, "Source face");
        if (source.shape != Shape::rigid &&
            contact.contact_point != Vector3{{0., 0., 0.}})
          refuse_entry(section,
                       "Contact point",
                       "is for rigid source bodies; a meshed one touches with "
                       "its face");
        check_sliding_direction(contact, section);
        if (contact.target_body == "ground")
          {
            if (source.shape != Shape::rigid)
              refuse_entry(section,
                           "Target body",
                           "= 'ground' is for rigid source bodies; a meshed "
                           "one needs a meshed target");
            if (!contact.target_face.empty())
              refuse_entry(section,
                           "Target face",
                           "must be empty: the ground has no faces");
            if (contact.friction_direction ==
                ContactParameters::FrictionDirection::slip)
              refuse_entry(section,
                           "Friction direction",
                           "= slip is that of a target that turns, and "
                           "'ground' has no axis: set fixed y, or given with a "
                           "'Sliding direction'");
            return;
          }

        const BodyParameters &target =
          require_body(scene, contact.target_body, section, "Target body");
        require_face(target, contact.target_face, section, "Target face");
        if (&source == &target)
          refuse_entry(section, "Target body", "is the source body itself");
        if ((source.shape == Shape::rigid) != (target.shape == Shape::rigid))
          refuse_entry(section,
                       "Target body",
                       "must be " +
                         std::string(source.shape == Shape::rigid
                                       ? "rigid or 'ground'"
                                       : "meshed") +
                         " like the source body");

        const auto source_face = flat_face(source, contact.source_face);
        const auto target_face = flat_face(target, contact.target_face);
        if (source_face && target_face)
          {
            std::string fault = fault_of_touching(*source_face, *target_face);
            if (fault.empty())
              fault = fault_of_footprint(*source_face, *target_face);
            if (!fault.empty())
              refuse_pair(contact, fault);
          }
        require_sliding_along(target, contact, section);
      }



      /** Entries of another friction law than the one that is asked for. */
      void
      refuse_other_laws(const ContactParameters &contact,
                        const std::string       &section)
      {
        using Law                = ContactParameters::FrictionLaw;
        const auto require_unset = [&](const bool         is_set,
                                       const char *const  entry,
                                       const Law          law,
                                       const std::string &name) {
          if (is_set && contact.friction_law != law)
            refuse_entry(section,
                         entry,
                         "would be ignored: set 'Friction law = " + name +
                           "' or remove it");
        };
        require_unset(contact.static_friction_coefficient != 0.,
                      "Static friction coefficient",
                      Law::exponential,
                      "exponential");
        require_unset(contact.decay_speed != 0.,
                      "Decay speed",
                      Law::exponential,
                      "exponential");
        require_unset(!contact.friction_speeds.empty(),
                      "Friction speeds",
                      Law::table,
                      "table");
        require_unset(!contact.friction_coefficients.empty(),
                      "Friction coefficients",
                      Law::table,
                      "table");
      }

      void
      check_friction_law(const ContactParameters &contact,
                         const std::string       &section)
      {
        using Law = ContactParameters::FrictionLaw;
        refuse_other_laws(contact, section);
        if (contact.friction_law != Law::constant &&
            contact.friction_slope != 0.)
          refuse_entry(section,
                       "Friction slope",
                       "must be 0 with a 'Friction law' that has a slope of "
                       "its own");
        if (contact.friction_law == Law::exponential &&
            contact.static_friction_coefficient <
              std::abs(contact.friction_coefficient))
          refuse_entry(section,
                       "Static friction coefficient",
                       "must not be below the 'Friction coefficient'");
        if (contact.friction_law != Law::table)
          return;
        const auto &speeds = contact.friction_speeds;
        if (speeds.empty() || speeds.front() != 0. ||
            std::adjacent_find(speeds.begin(),
                               speeds.end(),
                               std::greater_equal<double>()) != speeds.end())
          refuse_entry(section, "Friction speeds", "must ascend from 0");
        if (contact.friction_coefficients.size() != speeds.size())
          refuse_entry(section,
                       "Friction coefficients",
                       "must be as many as 'Friction speeds'");
      }



      void
      check_law(const ContactParameters &contact, const std::string &section)
      {
        if (contact.transverse_slip_term && !(contact.sliding_speed > 0.))
          refuse_entry(section,
                       "Sliding speed",
                       "must be greater than 0 with the 'Transverse slip "
                       "term', which divides by it");
        if (contact.friction_slope != 0. && !(contact.sliding_speed > 0.))
          refuse_entry(section,
                       "Friction slope",
                       "must be 0 at 'Sliding speed = 0': it is that of "
                       "sliding, and the pair is at rest");
        check_friction_law(contact, section);
        if (contact.formulation != ContactParameters::Formulation::springs)
          return;
        const bool is_grid =
          contact.layout == ContactParameters::SpringLayout::grid;
        const double stiffness = is_grid ? contact.normal_stiffness
                                         : contact.normal_stiffness_per_area;
        if (!(stiffness > 0.))
          refuse_entry(
            section,
            is_grid ? "Normal stiffness" : "Normal stiffness per area",
            "= " + format_number(stiffness) + " must be greater than 0");
      }



      /** A grid stands on a rectangle: on another face points would be lost,
       * and stiffness with them. Faces of mesh files are judged when they are
       * read. */
      void
      check_grid(const SceneParameters   &scene,
                 const ContactParameters &contact,
                 const std::string       &section)
      {
        const BodyParameters &source =
          require_body(scene, contact.source_body, section, "Source body");
        if (contact.formulation == ContactParameters::Formulation::springs &&
            contact.layout == ContactParameters::SpringLayout::grid &&
            contact.grid != std::array<unsigned int, 2>{{1, 1}} &&
            (source.shape == Shape::annulus || source.shape == Shape::cylinder))
          refuse_entry(section,
                       "Spring layout",
                       "= grid needs a rectangular source face, and face " +
                         in_quotes(contact.source_face) + " of body " +
                         in_quotes(source.name) +
                         " is round: use 'quadrature' with the 'Normal "
                         "stiffness per area'");
      }
    } // namespace



    void
    check_contact_law(const ContactParameters &contact)
    {
      check_law(contact, "Scene/Contact " + contact.name);
    }



    void
    check_contacts(const SceneParameters &scene)
    {
      for (const ContactParameters &contact : scene.contacts)
        {
          const std::string section = "Scene/Contact " + contact.name;
          check_faces(scene, contact, section);
          check_law(contact, section);
          check_grid(scene, contact, section);
        }
    }
  } // namespace prm
} // namespace squeal
