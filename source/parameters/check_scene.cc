// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>

#include <squeal/parameters/checks.h>
#include <squeal/parameters/choices.h>
#include <squeal/parameters/face_geometry.h>
#include <squeal/parameters/names.h>
#include <squeal/parameters/numbers.h>
#include <squeal/parameters/text.h>

#include <algorithm>
#include <set>

namespace squeal
{
  namespace prm
  {
    namespace
    {
      using Shape = BodyParameters::Shape;

      std::string
      point_text(const Vector3 &p)
      {
        return "(" + format_number(p[0]) + ", " + format_number(p[1]) + ", " +
               format_number(p[2]) + ")";
      }



      /** Refuses a point beside the box around a body. */
      void
      require_point_on_body(const BodyParameters &body,
                            const Vector3        &point,
                            const std::string    &section,
                            const std::string    &entry)
      {
        const std::optional<Box> box = box_of(body);
        if (!box)
          return;
        const double slack = 1e-6 * box->size();
        for (unsigned int i = 0; i < 3; ++i)
          if (point[i] < box->lower[i] - slack ||
              point[i] > box->upper[i] + slack)
            refuse_entry(section,
                         entry,
                         "= " + point_text(point) + " m lies outside body " +
                           in_quotes(body.name) + ", which reaches from " +
                           point_text(box->lower) + " to " +
                           point_text(box->upper) + " m");
      }



      void
      check_point_springs(const SceneParameters  &scene,
                          const SpringParameters &spring,
                          const BodyParameters   &body,
                          const std::string      &section)
      {
        if (!spring.face.empty())
          refuse_entry(
            section, "Face", "is for 'Kind = area'; leave it empty for points");
        require_point_on_body(body, spring.first_point, section, "First point");
        require_point_on_body(body, spring.last_point, section, "Last point");
        if (spring.other_body != "ground")
          {
            const BodyParameters &other =
              require_body(scene, spring.other_body, section, "Other body");
            if (&other == &body)
              refuse_entry(section, "Other body", "is the body itself");
            require_point_on_body(
              other, spring.first_point, section, "First point");
            require_point_on_body(
              other, spring.last_point, section, "Last point");
          }
        const bool is_row = spring.first_point != spring.last_point;
        if (spring.number > 1 && !is_row)
          refuse_entry(section,
                       "Last point",
                       "must differ from 'First point' for a row of " +
                         std::to_string(spring.number) + " springs");
        if (spring.number == 1 && is_row)
          refuse_entry(section,
                       "Number",
                       "= 1: the row from 'First point' to 'Last point' has "
                       "at least 2 springs");
      }



      void
      check_spring(const SceneParameters &scene, const SpringParameters &spring)
      {
        const std::string     section = "Scene/Spring " + spring.name;
        const BodyParameters &body =
          require_body(scene, spring.body, section, "Body");
        if (spring.kind == SpringParameters::Kind::points)
          check_point_springs(scene, spring, body, section);
        else
          {
            const SpringParameters plain;
            if (spring.number != plain.number)
              refuse_entry(section,
                           "Number",
                           "= " + std::to_string(spring.number) +
                             " is for 'Kind = points'; a bed has its stiffness "
                             "by the area");
            if (spring.first_point != plain.first_point ||
                spring.last_point != plain.last_point)
              refuse_entry(section,
                           spring.first_point != plain.first_point
                             ? "First point"
                             : "Last point",
                           "is for 'Kind = points'; a bed lies on the whole "
                           "'Face'");
            if (body.shape == Shape::rigid)
              refuse_entry(section,
                           "Body",
                           "is a rigid body, which has no face; use 'Kind = "
                           "points'");
            require_face(body, spring.face, section, "Face");
            if (spring.other_body != "ground" &&
                &require_body(
                  scene, spring.other_body, section, "Other body") == &body)
              refuse_entry(section, "Other body", "is the body itself");
          }
        const Vector3 zero{{0., 0., 0.}};
        if (spring.direction == zero)
          refuse_entry(section, "Direction", "must not be 0");
        for (unsigned int c = 0; c < 3; ++c)
          {
            if (spring.stiffnesses[c] < 0.)
              refuse_entry(section, "Stiffnesses", "must not be negative");
            if (spring.dashpots[c] < 0.)
              refuse_entry(section, "Dashpots", "must not be negative");
          }
        if (spring.stiffness == 0. && spring.dashpot == 0. &&
            spring.stiffnesses == zero && spring.dashpots == zero)
          refuse_entry(section,
                       "Stiffness",
                       ", 'Dashpot', 'Stiffnesses' and 'Dashpots' are all 0: "
                       "the springs do nothing");
      }



      void
      check_support(const SceneParameters   &scene,
                    const SupportParameters &support)
      {
        using Kind                    = SupportParameters::Kind;
        const std::string     section = "Scene/Support " + support.name;
        const BodyParameters &body =
          require_body(scene, support.body, section, "Body");
        require_face(body, support.face, section, "Face");
        if (body.shape == Shape::rigid &&
            (support.kind == Kind::guided || support.kind == Kind::held))
          refuse_entry(section,
                       "Kind",
                       "= " + choice_name(support.kind) +
                         " is for faces of meshed bodies: hold a rigid body by "
                         "'Kind = components', 'x, y, rx, ry, rz' to guide it "
                         "along z");
        if (support.kind != Kind::components)
          {
            if (!support.components.empty())
              refuse_entry(section,
                           "Components",
                           "is for 'Kind = components'; leave it empty "
                           "otherwise");
            return;
          }
        if (support.components.empty())
          refuse_entry(section,
                       "Components",
                       "is empty: list what is held, for example 'x, y'");
        std::set<std::string> seen;
        for (const std::string &component : support.components)
          {
            if (!seen.insert(component).second)
              refuse_entry(section,
                           "Components",
                           "lists " + in_quotes(component) + " twice");
            if (component.size() == 2 && body.shape != Shape::rigid)
              refuse_entry(section,
                           "Components",
                           ": " + in_quotes(component) +
                             " is a rotation, which only rigid bodies have");
          }
      }



      void
      check_lumped_mass(const SceneParameters      &scene,
                        const LumpedMassParameters &mass)
      {
        const std::string     section = "Scene/Lumped mass " + mass.name;
        const BodyParameters &body =
          require_body(scene, mass.body, section, "Body");
        require_point_on_body(body, mass.point, section, "Point");
        if (turning_body(scene, body).rotation_speed != 0.)
          refuse_entry(section,
                       "Body",
                       "= " + in_quotes(body.name) +
                         " turns ('Rotation speed'), and what is seen from the "
                         "fixed frame has no mass at one of its points; spread "
                         "it around as a body of revolution");
        if (!(mass.mass > 0.))
          refuse_entry(section, "Mass", "must be greater than 0");
      }



      void
      check_load(const SceneParameters &scene, const LoadParameters &load)
      {
        const std::string     section = "Scene/Load " + load.name;
        const BodyParameters &body =
          require_body(scene, load.body, section, "Body");
        require_face(body, load.face, section, "Face");
        const Vector3 zero{{0., 0., 0.}};
        if (body.shape == Shape::rigid && load.pressure != 0.)
          refuse_entry(section,
                       "Pressure",
                       "needs a face, which a rigid body does not have; give "
                       "'Force' and 'Moment'");
        if (body.shape != Shape::rigid && load.moment != zero)
          refuse_entry(section,
                       "Moment",
                       "is for rigid bodies; tie the face to one and load "
                       "that");
      }



      void
      check_bodies(const SceneParameters &scene)
      {
        if (scene.bodies.empty())
          refuse_entry("Scene",
                       "Bodies",
                       "is empty: name at least one body and describe it in a "
                       "section 'Body <name>'");
        if (!scene.matrix_parts.empty())
          refuse_entry("Scene",
                       "Matrix parts",
                       "is for 'Kind = matrices'; leave it empty with bodies");
        for (const BodyParameters &body : scene.bodies)
          check_body(body);
        check_layers(scene);
        for (const TieParameters &tie : scene.ties)
          check_tie(scene, tie);
        for (const SpringParameters &spring : scene.springs)
          check_spring(scene, spring);
        for (const SupportParameters &support : scene.supports)
          check_support(scene, support);
        for (const LumpedMassParameters &mass : scene.lumped_masses)
          check_lumped_mass(scene, mass);
        for (const LoadParameters &load : scene.loads)
          check_load(scene, load);
        check_contacts(scene);
      }
    } // namespace



    void
    check_scene(const SceneParameters &scene)
    {
      if (scene.kind == SceneParameters::Kind::bodies)
        check_bodies(scene);
      else
        check_matrices(scene);
      check_damping(scene);
    }
  } // namespace prm
} // namespace squeal
