// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_base_root_action_h
#define squeal_base_root_action_h

#include <functional>
#include <string>

namespace squeal
{
  /** The @p text of rank 0 on all ranks; on one process, or without MPI, as it
   * is. */
  std::string from_root(const std::string &text);

  /**
   * Calls @p action on rank 0 while the others wait, and returns its text on all
   * ranks. What only the root sees (files, locks) then ends a run on all ranks:
   * where @p action throws InputError, every rank throws it.
   */
  std::string on_root(const bool                          is_root,
                      const std::function<std::string()> &action);
} // namespace squeal

#endif
