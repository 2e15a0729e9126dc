// SPDX-License-Identifier: LGPL-2.1-or-later
#include "drop_included.h"

#include <squeal/parameters/declarations.h>
#include <squeal/parameters/text.h>

#include <algorithm>
#include <set>

namespace squeal
{
  namespace prm
  {
    namespace
    {
      bool
      is_in(const std::string &path, const std::string &other)
      {
        return other == path || starts_with(other, path + "/");
      }

      bool
      holds_any(const PrmTree &tree, const std::string &path)
      {
        const auto is_there = [&path](const auto &item) {
          return is_in(path, item.path);
        };
        return std::any_of(
                 tree.entries.begin(), tree.entries.end(), is_there) ||
               std::any_of(
                 tree.sections.begin(), tree.sections.end(), is_there);
      }
    } // namespace



    bool
    drop_path(PrmTree &tree, const std::string &path)
    {
      const auto remove = [&path](auto &items) {
        const auto end =
          std::remove_if(items.begin(), items.end(), [&path](const auto &item) {
            return is_in(path, item.path);
          });
        const bool was_there = end != items.end();
        items.erase(end, items.end());
        return was_there;
      };
      const bool had_entries = remove(tree.entries);
      return remove(tree.sections) || had_entries;
    }



    std::vector<std::string>
    names_below(const PrmTree &tree, const std::string &section)
    {
      std::set<std::string> names;
      const auto            add = [&](std::string path) {
        for (; path.size() > section.size() &&
               (section.empty() || is_in(section, path));
             path = section_of(path))
          names.insert(section.empty() ? path
                                       : path.substr(section.size() + 1));
      };
      for (const RawEntry &entry : tree.entries)
        add(entry.path);
      for (const RawSection &other : tree.sections)
        add(other.path);
      return {names.begin(), names.end()};
    }



    void
    take_from_list(PrmTree           &included,
                   const PrmTree     &own,
                   const std::string &path)
    {
      const SectionFamily *family = family_of(path);
      if (family == nullptr || holds_any(included, path) ||
          holds_any(own, path))
        return;
      for (RawEntry &entry : included.entries)
        if (entry.path == family->list_path())
          {
            std::vector<std::string> names = split(entry.value, ',');
            names.erase(std::remove_if(names.begin(),
                                       names.end(),
                                       [&](const std::string &name) {
                                         return family->section(name) == path;
                                       }),
                        names.end());
            entry.value = join(names, ", ");
          }
    }
  } // namespace prm
} // namespace squeal
