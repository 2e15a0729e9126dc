// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_parameters_aliases_h
#define squeal_parameters_aliases_h

#include <squeal/parameters/prm_tree.h>

#include <string>
#include <vector>

namespace squeal
{
  namespace prm
  {
    /** An entry that has been renamed within its section. */
    struct EntryAlias
    {
      std::string former;  /**< generic path, "Scene/Body <name>/E modulus" */
      std::string present; /**< name of the entry, "Young modulus" */
    };

    /** The entries that have been renamed since the first release. */
    const std::vector<EntryAlias> &entry_aliases();

    /**
     * Gives former entries their present name and returns one line for each,
     * to be shown to the user. Throws InputError if both names are set.
     */
    std::vector<std::string> apply_aliases(
      PrmTree                       &tree,
      const std::vector<EntryAlias> &aliases);
  } // namespace prm
} // namespace squeal

#endif
