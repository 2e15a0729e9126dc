// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/parameters/checks.h>
#include <squeal/parameters/choices.h>
#include <squeal/parameters/text.h>

#include <algorithm>

namespace squeal
{
  namespace prm
  {
    namespace
    {
      using Shape = BodyParameters::Shape;

      /** Refuses an entry that names a face which a layer covers. */
      void
      require_bare(const SceneParameters &scene,
                   const std::string     &body,
                   const std::string     &face,
                   const std::string     &section,
                   const std::string     &entry)
      {
        for (const BodyParameters &layer : scene.bodies)
          if (layer.shape == Shape::layer && layer.layer_body == body &&
              layer.layer_face == face && section != "Scene/Body " + layer.name)
            refuse_entry(
              section,
              entry,
              "= " + in_quotes(face) + " of body " + in_quotes(body) +
                " is covered by the layer " + in_quotes(layer.name) +
                ": take the face 'outer' of " + in_quotes(layer.name));
      }



      void
      check_layer(const SceneParameters &scene, const BodyParameters &layer)
      {
        const std::string     section = "Scene/Body " + layer.name;
        const BodyParameters &below =
          require_body(scene, layer.layer_body, section, "Layer body");
        if (below.shape == Shape::rigid)
          refuse_entry(section,
                       "Layer body",
                       "= " + in_quotes(below.name) +
                         " is a rigid body, which has no faces");
        if (&below >= &layer)
          refuse_entry(section,
                       "Layer body",
                       "= " + in_quotes(below.name) +
                         " must stand before the layer in 'Scene/Bodies'");
        require_face(below, layer.layer_face, section, "Layer face");
        require_bare(
          scene, below.name, layer.layer_face, section, "Layer face");
      }



      template <typename Pairs>
      void
      check_pairs(const SceneParameters &scene,
                  const Pairs           &pairs,
                  const std::string     &kind)
      {
        for (const auto &pair : pairs)
          {
            const std::string section = kind + pair.name;
            require_bare(scene,
                         pair.source_body,
                         pair.source_face,
                         section,
                         "Source face");
            require_bare(scene,
                         pair.target_body,
                         pair.target_face,
                         section,
                         "Target face");
          }
      }



      template <typename Members>
      void
      check_faces(const SceneParameters &scene,
                  const Members         &members,
                  const std::string     &kind)
      {
        for (const auto &member : members)
          require_bare(
            scene, member.body, member.face, kind + member.name, "Face");
      }
    } // namespace



    void
    check_layers(const SceneParameters &scene)
    {
      bool has_layers = false;
      for (const BodyParameters &body : scene.bodies)
        if (body.shape == Shape::layer)
          {
            check_layer(scene, body);
            has_layers = true;
          }
      if (!has_layers)
        return;
      check_pairs(scene, scene.ties, "Scene/Tie ");
      check_pairs(scene, scene.contacts, "Scene/Contact ");
      check_faces(scene, scene.supports, "Scene/Support ");
      check_faces(scene, scene.loads, "Scene/Load ");
      check_faces(scene, scene.springs, "Scene/Spring ");
    }



    void
    check_modulus_tables(const Parameters &parameters)
    {
      using Analysis = Parameters::Analysis;
      const auto table =
        std::find_if(parameters.scene.bodies.begin(),
                     parameters.scene.bodies.end(),
                     [](const auto &body) { return body.has_modulus_table(); });
      if (table == parameters.scene.bodies.end())
        return;
      const std::string section = "Scene/Body " + table->name,
                        entry   = "Modulus table file";
      if (parameters.analysis != Analysis::cea &&
          parameters.analysis != Analysis::operating_matrix)
        refuse_entry(
          section,
          entry,
          "is read by 'Analysis = cea' and 'operating matrix' alone, "
          "whose moduli may depend on frequency: take one of them, or "
          "for '" +
            choice_name(parameters.analysis) +
            "' 'Young modulus' and 'Structural damping' at one "
            "frequency and temperature");
      if (parameters.eigen.solver == EigenParameters::Solver::direct ||
          parameters.eigen.compare_direct)
        refuse_entry("Eigenvalues",
                     parameters.eigen.compare_direct ? "Compare with direct"
                                                     : "Solver",
                     "solves with one modulus for all frequencies, but "
                     "body " +
                       in_quotes(table->name) + " has a 'Modulus table file'");
      if (parameters.output.export_matrices)
        refuse_entry("Output",
                     "Export matrices",
                     "= true writes one stiffness for all frequencies, but "
                     "body " +
                       in_quotes(table->name) + " has a 'Modulus table file'");
      for (const BodyParameters &body : parameters.scene.bodies)
        if (body.rotation_speed != 0.)
          refuse_entry(section,
                       entry,
                       "cannot be followed while a body turns through the "
                       "fixed frame: set 'Scene/Body " +
                         body.name + "/Rotation speed = 0'");
    }
  } // namespace prm
} // namespace squeal
