// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_source_parameters_drop_included_h
#define squeal_source_parameters_drop_included_h

#include <squeal/parameters/prm_tree.h>

#include <string>
#include <vector>

namespace squeal
{
  namespace prm
  {
    /** Removes the entry or the section @p path with all that is in it. Returns
     * whether there was anything to remove. */
    bool drop_path(PrmTree &tree, const std::string &path);

    /** All entries and sections of @p tree in @p section, as named from there. */
    std::vector<std::string> names_below(const PrmTree     &tree,
                                         const std::string &section);

    /** Takes the member of a family ("Scene/Body pad") that was dropped from
     * the
     * list of names in @p included ("Scene/Bodies"), unless @p included or
     * @p own hold such a section again. */
    void take_from_list(PrmTree           &included,
                        const PrmTree     &own,
                        const std::string &path);
  } // namespace prm
} // namespace squeal

#endif
