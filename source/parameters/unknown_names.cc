// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>

#include <squeal/parameters/declarations.h>
#include <squeal/parameters/names.h>
#include <squeal/parameters/text.h>
#include <squeal/parameters/unknown_names.h>

#include <algorithm>
#include <unordered_set>

namespace squeal
{
  namespace prm
  {
    namespace
    {
      /** " Allowed here: a, b." or nothing. */
      std::string
      allowed_here(const std::vector<std::string> &names)
      {
        return names.empty() ? "" : " Allowed here: " + join(names, ", ");
      }



      std::string
      place(const std::string &section)
      {
        return section.empty() ? "the top level"
                               : "section " + in_quotes(section);
      }



      /** "; did you mean 'x'?", or the place where the name is known, or just
       * the end of the sentence. */
      std::string
      hint(const std::string              &name,
           const std::vector<std::string> &candidates,
           const std::vector<std::string> &places)
      {
        const std::string nearest = did_you_mean(name, candidates);
        if (!nearest.empty() && places.empty())
          return nearest;
        if (!places.empty())
          {
            std::vector<std::string> texts;
            for (const std::string &section : places)
              texts.push_back(place(section));
            return "; it belongs in " + join(texts, " or ") + ".";
          }
        return ".";
      }



      /** Says which list has to name a member of a family. */
      [[noreturn]] void
      refuse_member(const SectionFamily &family,
                    const std::string   &section,
                    const Location      &location,
                    const PrmTree       &tree)
      {
        const std::string name =
          entry_of(section).substr(family.word.size() + 1);
        const RawEntry   *list  = tree.find(family.list_path());
        const std::string value = list == nullptr ? "" : list->value;
        throw InputError(
          location.text() + ": section " + in_quotes(section) + ": " +
          in_quotes(name) + " is not in '" + family.list_path() + " = " +
          value + "'" +
          (list == nullptr ? "" : " (" + list->location.text() + ")") +
          did_you_mean(name, split(value, ',')));
      }



      [[noreturn]] void
      refuse_section(const std::string &section,
                     const Location    &location,
                     const PrmTree     &tree,
                     const Schema      &schema)
      {
        if (const SectionFamily *family = family_of(section))
          refuse_member(*family, section, location, tree);

        const std::string        parent  = section_of(section);
        const std::string        name    = entry_of(section);
        std::vector<std::string> members = schema.sections_of(parent);
        std::vector<std::string> allowed, places;
        for (const std::string &member : members)
          if (family_of(path_of(parent, member)) == nullptr)
            allowed.push_back(member);
        for (const SectionFamily &family : section_families())
          {
            if (family.parent == parent)
              allowed.push_back(family.word + " <name>");
            if (family_of(path_of(family.parent, name)) == &family)
              places.push_back(family.parent);
          }
        for (const Schema::Section &other : schema.sections())
          if (entry_of(other.path) == name && family_of(other.path) == nullptr)
            places.push_back(section_of(other.path));
        members.insert(members.end(), allowed.begin(), allowed.end());
        throw InputError(location.text() + ": unknown section " +
                         in_quotes(section) + hint(name, members, places) +
                         allowed_here(allowed));
      }



      using Names = std::unordered_set<std::string>;

      /** Refuses the outermost part of @p section that is not among the
       * @p declared ones. */
      void
      check_section(const std::string &section,
                    const Location    &location,
                    const Names       &declared,
                    const PrmTree     &tree,
                    const Schema      &schema)
      {
        if (declared.count(section) > 0)
          return;
        check_section(section_of(section), location, declared, tree, schema);
        refuse_section(section, location, tree, schema);
      }



      void
      check_entry(const RawEntry &entry,
                  const Names    &declared,
                  const PrmTree  &tree,
                  const Schema   &schema,
                  const Schema   &generic)
      {
        const std::string section = section_of(entry.path);
        check_section(section, entry.location, declared, tree, schema);
        if (schema.find(entry.path) != nullptr)
          return;

        const std::string        name = entry_of(entry.path);
        std::vector<std::string> places;
        for (const Schema::Entry &other : generic.entries())
          if (other.name == name)
            places.push_back(other.section);
        const std::vector<std::string> names = schema.entries_of(section);
        throw InputError(entry.location.text() + ": unknown entry " +
                         in_quotes(entry.path) + hint(name, names, places) +
                         allowed_here(names));
      }
    } // namespace



    void
    check_names_are_known(const PrmTree &tree,
                          const Schema  &schema,
                          const Schema  &generic)
    {
      Names declared;
      for (const Schema::Section &section : schema.sections())
        declared.insert(section.path);
      for (const RawSection &section : tree.sections)
        check_section(section.path, section.location, declared, tree, schema);
      for (const RawEntry &entry : tree.entries)
        check_entry(entry, declared, tree, schema, generic);
    }



    void
    refuse_files_of(const std::string              &program,
                    const std::vector<std::string> &analyses,
                    const PrmTree                  &tree)
    {
      const RawEntry *entry = tree.find("Analysis");
      if (entry != nullptr &&
          std::count(analyses.begin(), analyses.end(), entry->value) > 0)
        throw InputError(entry->location.text() + ": 'Analysis = " +
                         entry->value + "' is for " + program +
                         "; ./squeal run takes the program that a file "
                         "needs");
    }
  } // namespace prm
} // namespace squeal
