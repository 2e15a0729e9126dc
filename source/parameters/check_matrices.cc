// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/parameters/checks.h>
#include <squeal/parameters/choices.h>

#include <algorithm>

namespace squeal
{
  namespace prm
  {
    namespace
    {
      /** Loads of an imported model are columns of its node table. */
      void
      check_imported_loads(const SceneParameters &scene)
      {
        if (!scene.loads.empty() && scene.node_table_file.empty())
          refuse_entry("Scene",
                       "Node table file",
                       "is empty: with matrices it holds the forces of the "
                       "loads, a column load_<name> for each");
        const LoadParameters plain;
        for (const LoadParameters &load : scene.loads)
          if (!load.body.empty() || !load.face.empty() ||
              load.force != plain.force || load.pressure != 0. ||
              load.moment != plain.moment)
            refuse_entry("Scene/Load " + load.name,
                         "Body",
                         "and its face, force, pressure and moment are for "
                         "'Kind = bodies': with matrices the forces are the "
                         "column load_" +
                           load.name + " of 'Node table file'");
      }



      /** Refuses what the pattern says of a pair. */
      void
      check_pattern_has_it(const ContactParameters &contact,
                           const std::string       &section)
      {
        const ContactParameters                          plain;
        const std::vector<std::pair<const char *, bool>> entries = {
          {"Grid", contact.grid == plain.grid},
          {"Contact point", contact.contact_point == plain.contact_point},
          {"Friction direction",
           contact.friction_direction == plain.friction_direction},
          {"Sliding direction",
           contact.sliding_direction == plain.sliding_direction}};
        for (const auto &[entry, is_plain] : entries)
          if (!is_plain)
            refuse_entry(section,
                         entry,
                         "is for 'Kind = bodies': with matrices the points and "
                         "their directions are in 'Scene/Contact pattern "
                         "file'; remove the entry");
      }



      /** Where they touch is in the pattern; the law is that of the sections.
       */
      void
      check_imported_contacts(const SceneParameters &scene)
      {
        for (const auto &[name, file] :
             {std::make_pair("Contact pattern file",
                             scene.contact_pattern_file),
              std::make_pair("Node table file", scene.node_table_file)})
          if (file.empty())
            refuse_entry(
              "Scene", name, "is empty: matrices with 'Contacts' need it");
        if (scene.contact_normal_stiffness != 0. ||
            scene.friction_coefficient != 0.)
          refuse_entry("Scene",
                       scene.friction_coefficient != 0.
                         ? "Friction coefficient"
                         : "Contact normal stiffness",
                       "belongs to a pattern without 'Contacts': each contact "
                       "has its own");
        for (const MatrixPartParameters &part : scene.matrix_parts)
          if (part.role == MatrixPartParameters::Role::friction ||
              part.role == MatrixPartParameters::Role::circulatory ||
              part.role == MatrixPartParameters::Role::normal_contact)
            refuse_entry("Scene/Matrix part " + part.name,
                         "Role",
                         "= " + choice_name(part.role) +
                           " belongs to a scene without 'Contacts', whose "
                           "matrices have the contact cut open");
        for (const ContactParameters &contact : scene.contacts)
          {
            const std::string section = "Scene/Contact " + contact.name;
            if (!contact.source_face.empty() || !contact.target_face.empty())
              refuse_entry(section,
                           contact.source_face.empty() ? "Target face"
                                                       : "Source face",
                           "must be empty: matrices have no faces, where they "
                           "touch is in 'Contact pattern file'");
            if (contact.source_body.empty())
              refuse_entry(section,
                           "Source body",
                           "is empty: name the body of the node table that "
                           "the pair presses on the other one");
            check_pattern_has_it(contact, section);
            check_contact_law(contact);
          }
      }



      bool
      has_role(const SceneParameters           &scene,
               const MatrixPartParameters::Role role)
      {
        return std::any_of(scene.matrix_parts.begin(),
                           scene.matrix_parts.end(),
                           [role](const MatrixPartParameters &part) {
                             return part.role == role;
                           });
      }



      /** Stiffness and friction of a pattern without contacts need something to
       * act on. */
      void
      check_slipping_pattern(const SceneParameters &scene)
      {
        const bool has_pattern = !scene.contact_pattern_file.empty();
        if (has_pattern && !(scene.contact_normal_stiffness > 0.))
          refuse_entry("Scene",
                       "Contact normal stiffness",
                       "must be greater than 0 with a 'Contact pattern file'");
        if (!has_pattern && scene.contact_normal_stiffness != 0.)
          refuse_entry("Scene",
                       "Contact normal stiffness",
                       "acts on nothing without a 'Contact pattern file': give "
                       "one or remove the entry");
        if (!has_pattern && scene.friction_coefficient != 0. &&
            !has_role(scene, MatrixPartParameters::Role::friction))
          refuse_entry("Scene",
                       "Friction coefficient",
                       "acts on nothing without a 'Contact pattern file' or a "
                       "matrix part of 'Role = friction': give one or remove "
                       "the entry");
      }
    } // namespace



    void
    check_matrices(const SceneParameters &scene)
    {
      using Role = MatrixPartParameters::Role;
      const std::vector<std::pair<const char *, bool>> lists = {
        {"Bodies", scene.bodies.empty()},
        {"Ties", scene.ties.empty()},
        {"Springs", scene.springs.empty()},
        {"Supports", scene.supports.empty()},
        {"Lumped masses", scene.lumped_masses.empty()}};
      for (const auto &[list, is_empty] : lists)
        if (!is_empty)
          refuse_entry("Scene",
                       list,
                       "is for 'Kind = bodies'; leave it empty with "
                       "matrices");

      if (!has_role(scene, Role::mass) || !has_role(scene, Role::stiffness))
        refuse_entry("Scene",
                     "Matrix parts",
                     std::string("has no part with 'Role = ") +
                       (has_role(scene, Role::mass) ? "stiffness'" : "mass'"));
      for (const MatrixPartParameters &part : scene.matrix_parts)
        require_file(part.file, "Scene/Matrix part " + part.name, "File", true);
      require_file(
        scene.contact_pattern_file, "Scene", "Contact pattern file", false);
      require_file(scene.node_table_file, "Scene", "Node table file", false);
      check_imported_loads(scene);
      if (!scene.contacts.empty())
        return check_imported_contacts(scene);
      check_slipping_pattern(scene);
    }
  } // namespace prm
} // namespace squeal
