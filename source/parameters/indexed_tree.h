// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_source_parameters_indexed_tree_h
#define squeal_source_parameters_indexed_tree_h

#include <squeal/parameters/prm_tree.h>

#include <string>
#include <unordered_map>
#include <utility>

namespace squeal
{
  namespace prm
  {
    /** A tree that finds its entries at once. */
    class IndexedTree
    {
    public:
      const RawEntry *
      find(const std::string &path) const
      {
        const auto place = index.find(path);
        return place == index.end() ? nullptr : &tree.entries[place->second];
      }

      void
      set(const RawEntry &entry)
      {
        const auto place = index.emplace(entry.path, tree.entries.size());
        if (place.second)
          tree.entries.push_back(entry);
        else
          tree.entries[place.first->second] = entry;
      }

      /** Adds what is in @p other; its entries override those here. */
      void
      add(const PrmTree &other)
      {
        for (const RawEntry &entry : other.entries)
          set(entry);
        tree.sections.insert(
          tree.sections.end(), other.sections.begin(), other.sections.end());
      }

      void
      add_section(const RawSection &section)
      {
        tree.sections.push_back(section);
      }

      const PrmTree &
      operator*() const
      {
        return tree;
      }

      /** Another tree in place of this one. */
      void
      become(PrmTree &&changed)
      {
        tree = std::move(changed);
        index.clear();
        for (std::size_t i = 0; i < tree.entries.size(); ++i)
          index[tree.entries[i].path] = i;
      }

    private:
      PrmTree                                      tree;
      std::unordered_map<std::string, std::size_t> index;
    };
  } // namespace prm
} // namespace squeal

#endif
