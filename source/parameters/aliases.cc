// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>

#include <squeal/parameters/aliases.h>
#include <squeal/parameters/declarations.h>
#include <squeal/parameters/text.h>

namespace squeal
{
  namespace prm
  {
    const std::vector<EntryAlias> &
    entry_aliases()
    {
      static const std::vector<EntryAlias> aliases;
      return aliases;
    }



    std::vector<std::string>
    apply_aliases(PrmTree &tree, const std::vector<EntryAlias> &aliases)
    {
      std::vector<std::string> notes;
      for (const EntryAlias &alias : aliases)
        for (RawEntry &entry : tree.entries)
          {
            if (generic_path(entry.path) != alias.former)
              continue;
            const std::string path =
              path_of(section_of(entry.path), alias.present);
            if (const RawEntry *present = tree.find(path))
              throw InputError(
                entry.location.text() + ": " + in_quotes(entry.path) +
                " is the former name of " + in_quotes(alias.present) +
                ", which is set at " + present->location.text() +
                ": remove one of them");
            notes.push_back(entry.location.text() + ": " +
                            in_quotes(entry.path) + " is now called " +
                            in_quotes(alias.present));
            entry.path = path;
          }
      return notes;
    }
  } // namespace prm
} // namespace squeal
