// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/parameters/declarations.h>
#include <squeal/parameters/prm_tree.h>
#include <squeal/parameters/text.h>
#include <squeal/run/entry_units.h>

namespace squeal
{
  namespace
  {
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
    const prm::GenericSchema generic;
    // One of several numbers, "Young moduli[2]", has the unit of all.
    const prm::Schema::Entry *entry = generic->find(
      prm::generic_path(prm::normal_path(path.substr(0, path.find('[')))));
    if (!entry || entry->units == "none")
      return "";
    // "N/m, bed N/m^3"
    const std::string mark = ", bed ";
    const std::size_t bed  = entry->units.find(mark);
    return bed == std::string::npos ? entry->units
           : is_of_bed(prm::normal_path(path), scene)
             ? entry->units.substr(bed + mark.size())
             : entry->units.substr(0, bed);
  }
} // namespace squeal
