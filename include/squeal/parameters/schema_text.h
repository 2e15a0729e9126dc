// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_parameters_schema_text_h
#define squeal_parameters_schema_text_h

#include <squeal/parameters/prm_tree.h>
#include <squeal/parameters/schema.h>

#include <functional>
#include <iosfwd>
#include <string>
#include <utility>
#include <vector>

namespace squeal
{
  namespace prm
  {
    /** Every entry as used: "Section/Sub/Entry" and value, in declared
     * order. */
    using UsedEntries = std::vector<std::pair<std::string, std::string>>;

    /**
     * @name Of any schema
     * What every program of the project does with its parameter files.
     * @p generic is a schema with one member "<name>" of each family.
     */
    //@{
    /** Compares @p tree with @p schema, sets and assigns every value and
     * returns the entries as used. Throws InputError. */
    UsedEntries fill_schema(const PrmTree &tree,
                            Schema        &schema,
                            const Schema  &generic);

    /** The names in a list entry @p list_path that stand for sections
     * "<section> <name>", which must be there. Throws InputError. */
    std::vector<std::string> listed_names(
      const PrmTree                                         &tree,
      const std::string                                     &list_path,
      const std::function<std::string(const std::string &)> &section);

    /** See print_defaults(). */
    void print_defaults(const Schema &generic, std::ostream &out);

    /** The tables of print_parameter_documentation(), without its heading. */
    void print_documentation(const Schema &generic, std::ostream &out);

    /** See print_parameters(). */
    void print_used(const UsedEntries &used,
                    const Schema      &generic,
                    std::ostream      &out);

    /** See write_used_parameters(). */
    void write_used(const UsedEntries &used,
                    const Schema      &generic,
                    const std::string &file);
    //@}
  } // namespace prm
} // namespace squeal

#endif
