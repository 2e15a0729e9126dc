// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_setup_unused_entries_h
#define squeal_tribology_setup_unused_entries_h

#include <string>

namespace squeal::tribology
{
  /** Refuses an entry that differs from its default, so that it @p is_set,
   * although nothing takes it: the run would tell what it tells without it.
   * @p condition tells why, and what to do. Throws InputError. */
  void refuse_without_effect(const std::string &section,
                             const std::string &entry,
                             bool               is_set,
                             bool               is_used,
                             const std::string &condition);
} // namespace squeal::tribology

#endif
