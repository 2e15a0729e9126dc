// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>

#include <squeal/parameters/aliases.h>
#include <squeal/parameters/declarations.h>
#include <squeal/parameters/names.h>
#include <squeal/parameters/parameters.h>
#include <squeal/parameters/prm_tree.h>
#include <squeal/parameters/text.h>
#include <squeal/parameters/unknown_names.h>

#include <algorithm>

namespace squeal
{
  namespace prm
  {
    namespace
    {
      bool
      mentions_section(const PrmTree &tree, const std::string &section)
      {
        const auto is_inside = [&section](const RawEntry &entry) {
          return starts_with(entry.path, section + "/");
        };
        return tree.find_section(section) != nullptr ||
               std::any_of(tree.entries.begin(), tree.entries.end(), is_inside);
      }



      /** The names in the list of @p family; each must have its section. */
      std::vector<std::string>
      listed_names(const PrmTree &tree, const SectionFamily &family)
      {
        const RawEntry *list = tree.find(family.list_path());
        if (list == nullptr)
          return {};
        const std::vector<std::string> names = split(list->value, ',');
        const std::string start = list->location.text() + ": '" + list->path +
                                  " = " + list->value + "': ";
        const std::string fault = fault_of_names(names);
        if (!fault.empty())
          throw InputError(start + fault);
        for (const std::string &name : names)
          if (!mentions_section(tree, family.section(name)))
            throw InputError(start + "there is no section " +
                             quoted(family.section(name)) +
                             "; add it or remove the name");
        return names;
      }
    } // namespace



    Parameters
    parse_tree(PrmTree tree, const std::string &file)
    {
      Parameters parameters;
      parameters.file  = file;
      parameters.notes = apply_aliases(tree, entry_aliases());

      for (const SectionFamily &family : section_families())
        name_members(parameters, family, listed_names(tree, family));
      Schema schema;
      declare_parameters(schema, parameters);

      check_names_are_known(tree, schema);
      for (const RawEntry &entry : tree.entries)
        schema.set(entry);
      schema.assign();
      for (const Schema::Entry &entry : schema.entries())
        parameters.used.emplace_back(entry.path(), schema.value(entry));
      return parameters;
    }
  } // namespace prm



  Parameters
  read_parameters(const std::string              &file,
                  const std::vector<std::string> &overrides)
  {
    prm::PrmTree tree = prm::read_prm_file(file);
    for (const std::string &text : overrides)
      tree.set(prm::parse_override(text));
    return prm::parse_tree(std::move(tree), file);
  }
} // namespace squeal
