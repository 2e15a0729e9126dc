// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/parameters/declarations.h>
#include <squeal/parameters/text.h>

#include <deal.II/base/exceptions.h>

namespace squeal
{
  namespace prm
  {
    namespace
    {
      template <typename Action>
      void
      for_each_family(Parameters &parameters, const Action &action)
      {
        SceneParameters &scene = parameters.scene;
        action(family_named("Bodies"), scene.bodies);
        action(family_named("Ties"), scene.ties);
        action(family_named("Springs"), scene.springs);
        action(family_named("Supports"), scene.supports);
        action(family_named("Lumped masses"), scene.lumped_masses);
        action(family_named("Loads"), scene.loads);
        action(family_named("Contacts"), scene.contacts);
        action(family_named("Matrix parts"), scene.matrix_parts);
        action(family_named("Axes"), parameters.sweep.axes);
        action(family_named("Points"), parameters.measurement.points);
        action(family_named("Numbers"), parameters.updating.numbers);
        action(family_named("Checks"), parameters.result_checks);
      }
    } // namespace



    std::string
    SectionFamily::list_path() const
    {
      return path_of(parent, list);
    }



    std::string
    SectionFamily::section(const std::string &name) const
    {
      return path_of(parent, word + " " + name);
    }



    const std::vector<SectionFamily> &
    section_families()
    {
      static const std::vector<SectionFamily> families = {
        {"Scene", "Bodies", "Body", "One body: a meshed solid or a rigid one."},
        {"Scene",
         "Ties",
         "Tie",
         "Two faces of different bodies that move as one."},
        {"Scene",
         "Springs",
         "Spring",
         "A row of equal point springs, or an elastic bed on a face, with "
         "dashpots in parallel."},
        {"Scene", "Supports", "Support", "Displacements that are held at 0."},
        {"Scene",
         "Lumped masses",
         "Lumped mass",
         "A point mass that a body carries."},
        {"Scene", "Loads", "Load", "A force spread evenly over a face."},
        {"Scene", "Contacts", "Contact", "A frictional contact pair."},
        {"Scene",
         "Matrix parts",
         "Matrix part",
         "One part of the matrices of an imported model."},
        {"Sweep",
         "Axes",
         "Axis",
         "One direction of the sweep: a number of the scene, or several that "
         "move together."},
        {"Measurement",
         "Points",
         "Point",
         "A point and direction where the structure is excited or observed."},
        {"Updating",
         "Numbers",
         "Number",
         "A number of the scene that is fitted, or several with a common "
         "factor."},
        {"Result checks",
         "Checks",
         "Check",
         "One value of a result table that is compared with an expected one "
         "at the end of the run."}};
      return families;
    }



    const SectionFamily &
    family_named(const std::string &list)
    {
      const std::vector<SectionFamily> &families = section_families();
      std::size_t                       i        = 0;
      while (families[i].list != list)
        {
          ++i;
          AssertIndexRange(i, families.size());
        }
      return families[i];
    }



    const SectionFamily *
    family_of(const std::string &section)
    {
      for (const SectionFamily &family : section_families())
        if (section_of(section) == family.parent &&
            starts_with(entry_of(section), family.word + " "))
          return &family;
      return nullptr;
    }



    std::string
    generic_path(const std::string &path)
    {
      std::string generic;
      // not the entry itself: "Contact pattern file" is no contact
      for (const std::string &name : split(section_of(path), '/'))
        {
          generic                     = path_of(generic, name);
          const SectionFamily *family = family_of(generic);
          if (family != nullptr)
            generic = family->section("<name>");
        }
      return path_of(generic, entry_of(path));
    }



    void
    name_members(Parameters                     &parameters,
                 const SectionFamily            &family,
                 const std::vector<std::string> &names)
    {
      const auto name_those = [&](const SectionFamily &candidate,
                                  auto                &members) {
        if (&candidate != &family)
          return;
        members.clear();
        for (const std::string &name : names)
          {
            members.emplace_back();
            members.back().name = name;
          }
      };
      for_each_family(parameters, name_those);
    }



    void
    declare_list(Schema &schema, const SectionFamily &family)
    {
      schema.declare(
        {schema.section_path(),
         family.list,
         "",
         Allowed::names(),
         "Names of the sections '" + family.word + " <name>', one for each.",
         "none",
         [](const std::string &) {}});
    }



    GenericSchema::GenericSchema()
    {
      for (const SectionFamily &family : section_families())
        name_members(parameters, family, {"<name>"});
      declare_parameters(schema, parameters);
    }



    const Schema &
    GenericSchema::operator*() const
    {
      return schema;
    }



    const Schema *
    GenericSchema::operator->() const
    {
      return &schema;
    }
  } // namespace prm
} // namespace squeal
