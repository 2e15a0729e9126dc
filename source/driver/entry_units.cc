// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/driver/entry_units.h>
#include <squeal/parameters/declarations.h>
#include <squeal/parameters/prm_tree.h>

namespace squeal
{
  std::string
  unit_of_entry(const std::string &path)
  {
    const prm::GenericSchema generic;
    // One of several numbers, "Young moduli[2]", has the unit of all.
    const prm::Schema::Entry *entry = generic->find(
      prm::generic_path(prm::normal_path(path.substr(0, path.find('[')))));
    return entry && entry->units != "none" ? entry->units : "";
  }
} // namespace squeal
