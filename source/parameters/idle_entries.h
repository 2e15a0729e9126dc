// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_source_parameters_idle_entries_h
#define squeal_source_parameters_idle_entries_h

#include <squeal/parameters/parameters.h>
#include <squeal/parameters/prm_tree.h>
#include <squeal/parameters/schema.h>

namespace squeal
{
  namespace prm
  {
    /**
     * Looks for entries of @p tree that differ from their defaults and have no
     * effect beside another entry: those of another shape of a body, springs of
     * a contact without them. An entry counts unless that other one was set
     * after it, by --set or by a file that includes the file of the entry:
     * a file may say otherwise than those it includes.
     *
     * Names them in one note of @p parameters. Those that check_body() refuses
     * get their defaults in @p schema and @p parameters where another file has
     * changed the shape, and are left to it otherwise.
     *
     * @return whether an entry got its default
     */
    bool settle_idle_entries(const PrmTree &tree,
                             Schema        &schema,
                             Parameters    &parameters);
  } // namespace prm
} // namespace squeal

#endif
