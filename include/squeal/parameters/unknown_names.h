// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_parameters_unknown_names_h
#define squeal_parameters_unknown_names_h

#include <squeal/parameters/prm_tree.h>
#include <squeal/parameters/schema.h>

namespace squeal
{
  namespace prm
  {
    /**
     * Throws InputError for the first section or entry of @p tree that is not
     * declared: location, what is unknown, the nearest name, and what is
     * allowed there, in one line. @p generic has one member of each family.
     */
    void check_names_are_known(const PrmTree &tree,
                               const Schema  &schema,
                               const Schema  &generic);

    /** Throws InputError, with the location, where the entry 'Analysis' of
     * @p tree is one of those of another @p program: what else is in the file
     * would be unknown for no reason that the user can see. */
    void refuse_files_of(const std::string              &program,
                         const std::vector<std::string> &analyses,
                         const PrmTree                  &tree);
  } // namespace prm
} // namespace squeal

#endif
