// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>

#include <squeal/parameters/aliases.h>
#include <squeal/parameters/declarations.h>
#include <squeal/parameters/names.h>
#include <squeal/parameters/parameters.h>
#include <squeal/parameters/prm_tree.h>
#include <squeal/parameters/schema_text.h>
#include <squeal/parameters/text.h>
#include <squeal/parameters/unknown_names.h>

#include <unordered_set>

#include "idle_entries.h"

namespace squeal
{
  namespace prm
  {
    namespace
    {
      /** Every section that is opened or that an entry stands in. */
      std::unordered_set<std::string>
      mentioned_sections(const PrmTree &tree)
      {
        std::unordered_set<std::string> sections;
        for (const RawSection &section : tree.sections)
          sections.insert(section.path);
        for (const RawEntry &entry : tree.entries)
          for (std::string path = section_of(entry.path); !path.empty();
               path             = section_of(path))
            sections.insert(path);
        return sections;
      }

      UsedEntries
      used_entries(const Schema &schema)
      {
        UsedEntries used;
        for (const Schema::Entry &entry : schema.entries())
          used.emplace_back(entry.path(), schema.value(entry));
        return used;
      }
    } // namespace



    std::vector<std::string>
    listed_names(const PrmTree     &tree,
                 const std::string &list_path,
                 const std::function<std::string(const std::string &)> &section)
    {
      const RawEntry *list = tree.find(list_path);
      if (list == nullptr)
        return {};
      const std::vector<std::string> names = split(list->value, ',');
      const std::string start = list->location.text() + ": '" + list->path +
                                " = " + list->value + "': ";
      const std::string fault = fault_of_names(names);
      if (!fault.empty())
        throw InputError(start + fault);
      const std::unordered_set<std::string> mentioned =
        names.empty() ? std::unordered_set<std::string>()
                      : mentioned_sections(tree);
      for (const std::string &name : names)
        if (mentioned.count(section(name)) == 0)
          throw InputError(start + "there is no section " +
                           in_quotes(section(name)) +
                           "; add it or remove the name");
      return names;
    }



    UsedEntries
    fill_schema(const PrmTree &tree, Schema &schema, const Schema &generic)
    {
      check_names_are_known(tree, schema, generic);
      for (const RawEntry &entry : tree.entries)
        schema.set(entry);
      schema.assign();
      return used_entries(schema);
    }



    Parameters
    parse_tree(PrmTree tree, const std::string &file)
    {
      Parameters parameters;
      parameters.file  = file;
      parameters.notes = apply_aliases(tree, entry_aliases());

      for (const SectionFamily &family : section_families())
        name_members(parameters,
                     family,
                     listed_names(tree,
                                  family.list_path(),
                                  [&family](const std::string &name) {
                                    return family.section(name);
                                  }));
      Schema schema;
      declare_parameters(schema, parameters);

      const GenericSchema generic;
      parameters.used = fill_schema(tree, schema, *generic);
      if (settle_idle_entries(tree, schema, parameters))
        parameters.used = used_entries(schema);
      return parameters;
    }
  } // namespace prm



  namespace
  {
    /** As in choices(TribologyParameters::Analysis), which this library does
     * not know. */
    const std::vector<std::string> analyses_of_tribology = {
      "damage",
      "segmentation",
      "correlation",
      "synthetic specimen",
      "recorded history"};
  } // namespace



  Parameters
  read_parameters(const std::string              &file,
                  const std::vector<std::string> &overrides)
  {
    prm::PrmTree tree = prm::read_prm_file(file);
    for (const std::string &text : overrides)
      tree.set(prm::parse_override(text));
    prm::refuse_files_of("squeal-tribology", analyses_of_tribology, tree);
    return prm::parse_tree(std::move(tree), file);
  }
} // namespace squeal
