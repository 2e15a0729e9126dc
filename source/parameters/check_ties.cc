// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>

#include <squeal/parameters/checks.h>
#include <squeal/parameters/face_geometry.h>
#include <squeal/parameters/numbers.h>
#include <squeal/parameters/text.h>

namespace squeal
{
  namespace prm
  {
    namespace
    {
      using Shape = BodyParameters::Shape;

      /** What is tied turns as one body: with one speed about one line. */
      void
      check_tied_turning(const SceneParameters &scene,
                         const BodyParameters  &source,
                         const BodyParameters  &target,
                         const std::string     &section)
      {
        const BodyParameters &a = turning_body(scene, source),
                             &b = turning_body(scene, target);
        if (a.rotation_speed != b.rotation_speed)
          refuse_entry(section,
                       "Target body",
                       ": " + in_quotes(source.name) + " turns with " +
                         format_number(a.rotation_speed) +
                         " rad/s ('Rotation speed') and " +
                         in_quotes(target.name) + " with " +
                         format_number(b.rotation_speed) +
                         ", but what is tied turns together");
        if (a.rotation_speed != 0. && !have_centres_on_one_axis(a, b))
          refuse_entry(section,
                       "Target body",
                       ": " + in_quotes(source.name) + " and " +
                         in_quotes(target.name) +
                         " turn ('Rotation speed') about different lines: give "
                         "them one 'Rotation centre' (without an entry it is "
                         "the 'Position' of each body)");
      }
    } // namespace



    const BodyParameters &
    turning_body(const SceneParameters &scene, const BodyParameters &body)
    {
      if (body.shape != Shape::layer)
        return body;
      // Layers stand behind what they lie on.
      for (const BodyParameters &below : scene.bodies)
        if (&below == &body)
          break;
        else if (below.name == body.layer_body)
          return turning_body(scene, below);
      return body;
    }

    bool
    have_centres_on_one_axis(const BodyParameters &a, const BodyParameters &b)
    {
      const Vector3 &axis = a.rotation_axis, &x = a.centre_of_rotation(),
                    &y = b.centre_of_rotation();
      double along = 0., square = 0., distance = 0., size = 0.;
      for (unsigned int c = 0; c < 3; ++c)
        {
          along += axis[c] * (y[c] - x[c]);
          square += axis[c] * axis[c];
          size += x[c] * x[c] + y[c] * y[c];
        }
      for (unsigned int c = 0; c < 3; ++c)
        {
          const double beside = y[c] - x[c] - along / square * axis[c];
          distance += beside * beside;
        }
      return distance <= 1e-18 * size;
    }



    void
    check_tie(const SceneParameters &scene, const TieParameters &tie)
    {
      const std::string     section = "Scene/Tie " + tie.name;
      const BodyParameters &source =
        require_body(scene, tie.source_body, section, "Source body");
      const BodyParameters &target =
        require_body(scene, tie.target_body, section, "Target body");
      if (&source == &target)
        refuse_entry(section, "Target body", "is the source body itself");
      if (source.shape == Shape::rigid)
        refuse_entry(section,
                     "Source body",
                     "is a rigid body: a tie leads a face of a meshed body; "
                     "exchange source and target");
      require_face(source, tie.source_face, section, "Source face");
      require_face(target, tie.target_face, section, "Target face");
      check_tied_turning(scene, source, target, section);
      if (target.shape == Shape::rigid &&
          tie.kind == TieParameters::Kind::conforming)
        refuse_entry(section,
                     "Kind",
                     "= conforming: a rigid target has no nodes in common "
                     "with the source; leave it 'automatic'");
      const auto source_face = flat_face(source, tie.source_face);
      const auto target_face = flat_face(target, tie.target_face);
      if (!source_face || !target_face)
        return;
      const std::string fault = fault_of_touching(*source_face, *target_face);
      if (!fault.empty())
        throw InputError("tie " + tie.name + ": faces do not meet: " + fault +
                         "; change the 'Position' of one of the bodies");
    }
  } // namespace prm
} // namespace squeal
