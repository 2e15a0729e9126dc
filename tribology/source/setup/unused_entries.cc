// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/parameters/checks.h>
#include <squeal/tribology/setup/unused_entries.h>

namespace squeal::tribology
{
  void
  refuse_without_effect(const std::string &section,
                        const std::string &entry,
                        const bool         is_set,
                        const bool         is_used,
                        const std::string &condition)
  {
    if (is_set && !is_used)
      prm::refuse_entry(
        section, entry, "is set but has no effect " + condition);
  }
} // namespace squeal::tribology
