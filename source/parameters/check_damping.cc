// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/parameters/checks.h>
#include <squeal/parameters/choices.h>
#include <squeal/parameters/numbers.h>

namespace squeal
{
  namespace prm
  {
    namespace
    {
      using Model = DampingParameters::Model;

      /** Refuses a damping entry that the damping model would not use. */
      void
      require_unused(const double       value,
                     const std::string &section,
                     const std::string &entry,
                     const std::string &needed_model)
      {
        if (value != 0.)
          refuse_entry(section,
                       entry,
                       "= " + format_number(value) +
                         " would be ignored: set 'Scene/Damping/Model = " +
                         needed_model + "' or remove it");
      }

      /** Refuses damping by the stiffness of a part that has none. */
      template <typename Part>
      void
      require_no_elastic_damping(const Part        &part,
                                 const std::string &section,
                                 const std::string &reason)
      {
        for (const auto &[entry, value] :
             {std::make_pair("Stiffness damping", part.stiffness_damping),
              std::make_pair("Structural damping", part.structural_damping)})
          if (value != 0.)
            refuse_entry(section,
                         entry,
                         "= " + format_number(value) +
                           " would be ignored: " + reason);
      }

      void
      check_parts_without_stiffness(const SceneParameters &scene)
      {
        for (const BodyParameters &body : scene.bodies)
          if (body.shape == BodyParameters::Shape::rigid)
            require_no_elastic_damping(body,
                                       "Scene/Body " + body.name,
                                       "a rigid body has no stiffness; it has "
                                       "'Mass damping' only");
        for (const ContactParameters &contact : scene.contacts)
          if (contact.formulation != ContactParameters::Formulation::springs)
            require_no_elastic_damping(
              contact,
              "Scene/Contact " + contact.name,
              "a contact of 'Formulation = " +
                choice_name(contact.formulation) +
                "' has no springs; it is for 'Formulation = springs'");
      }



      /** Damping of single parts, where the whole model or nothing has it. */
      void
      check_no_damping_of_parts(const SceneParameters &scene)
      {
        const auto check_part = [](const std::string &section,
                                   const auto        &part) {
          require_unused(
            part.stiffness_damping, section, "Stiffness damping", "per part");
          require_unused(
            part.structural_damping, section, "Structural damping", "per part");
        };
        for (const BodyParameters &body : scene.bodies)
          {
            const std::string section = "Scene/Body " + body.name;
            require_unused(
              body.mass_damping, section, "Mass damping", "per part");
            check_part(section, body);
          }
        for (const SpringParameters &spring : scene.springs)
          check_part("Scene/Spring " + spring.name, spring);
        for (const ContactParameters &contact : scene.contacts)
          check_part("Scene/Contact " + contact.name, contact);
      }
    } // namespace



    void
    check_damping(const SceneParameters &scene)
    {
      check_parts_without_stiffness(scene);
      const DampingParameters &d = scene.damping;
      if (d.model != Model::whole_model)
        {
          const std::string section = "Scene/Damping", model = "whole model";
          require_unused(d.mass_damping, section, "Mass damping", model);
          require_unused(
            d.stiffness_damping, section, "Stiffness damping", model);
          require_unused(
            d.structural_damping, section, "Structural damping", model);
        }
      if (d.model != Model::per_part)
        check_no_damping_of_parts(scene);
    }
  } // namespace prm
} // namespace squeal
