// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/parameters/declarations.h>
#include <squeal/parameters/entry_traits.h>
#include <squeal/parameters/prm_tree.h>
#include <squeal/parameters/text.h>

namespace squeal
{
  namespace
  {
    /** The declaration, or null. */
    const prm::Schema::Entry *
    declaration(const std::string &path)
    {
      static const prm::GenericSchema generic;
      return generic->find(
        prm::generic_path(prm::normal_path(path.substr(0, path.find('[')))));
    }

    bool
    is_of_bed(const std::string &path, const SceneParameters &scene)
    {
      for (const auto &spring : scene.springs)
        if (spring.kind == SpringParameters::Kind::area &&
            prm::section_of(path) == "Scene/Spring " + spring.name)
          return true;
      return false;
    }
  } // namespace



  std::string
  unit_of_entry(const std::string &path, const SceneParameters &scene)
  {
    const prm::Schema::Entry *entry = declaration(path);
    if (!entry || entry->units == "none")
      return "";
    return !entry->units_of_bed.empty() &&
               is_of_bed(prm::normal_path(path), scene)
             ? entry->units_of_bed
             : entry->units;
  }

  bool
  is_affine_entry(const std::string &path)
  {
    const prm::Schema::Entry *entry = declaration(path);
    return entry && entry->is_affine;
  }

  bool
  is_friction_entry(const std::string &path)
  {
    const prm::Schema::Entry *entry = declaration(path);
    return entry && entry->is_friction;
  }

  bool
  is_resolution_entry(const std::string &path)
  {
    const prm::Schema::Entry *entry = declaration(path);
    return entry && entry->is_resolution;
  }
} // namespace squeal
