// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>

#include <squeal/parameters/prm_tree.h>
#include <squeal/parameters/text.h>

#include <algorithm>
#include <filesystem>
#include <limits>

namespace squeal
{
  namespace prm
  {
    std::string
    Location::text() const
    {
      return line == 0 ? file : file + ":" + std::to_string(line);
    }



    const RawEntry *
    PrmTree::find(const std::string &path) const
    {
      const auto entry =
        std::find_if(entries.begin(),
                     entries.end(),
                     [&path](const RawEntry &e) { return e.path == path; });
      return entry == entries.end() ? nullptr : &*entry;
    }



    void
    PrmTree::set(const RawEntry &entry)
    {
      const auto same = std::find_if(
        entries.begin(), entries.end(), [&entry](const RawEntry &e) {
          return e.path == entry.path;
        });
      if (same == entries.end())
        entries.push_back(entry);
      else
        *same = entry;
    }



    const RawSection *
    PrmTree::find_section(const std::string &path) const
    {
      const auto section =
        std::find_if(sections.begin(),
                     sections.end(),
                     [&path](const RawSection &s) { return s.path == path; });
      return section == sections.end() ? nullptr : &*section;
    }



    std::string
    normal_path(const std::string &path)
    {
      std::vector<std::string> names = split(path, '/');
      for (std::string &name : names)
        name = collapse_blanks(name);
      return join(names, "/");
    }



    RawEntry
    parse_override(const std::string &text)
    {
      const std::size_t equals = text.find('=');
      RawEntry          entry;
      entry.location.file = "--set";
      entry.path          = normal_path(text.substr(0, equals));
      if (!is_utf8(text))
        throw InputError("--set: a setting holds letters in another encoding "
                         "than UTF-8");
      if (equals == std::string::npos || entry.path.empty())
        throw InputError("--set " + in_quotes(text) +
                         ": write it as 'Section/Entry = value'");
      entry.value     = trim(text.substr(equals + 1));
      entry.directory = std::filesystem::current_path().string();
      entry.order     = std::numeric_limits<unsigned int>::max();

      // such a value could not be written to a file and read back
      const bool is_line =
        std::none_of(entry.value.begin(), entry.value.end(), [](const char c) {
          return static_cast<unsigned char>(c) < 0x20;
        });
      if (!is_line || entry.value.find(" #") != std::string::npos ||
          starts_with(entry.value, "#") ||
          (!entry.value.empty() && entry.value.back() == '\\'))
        throw InputError("--set " + in_quotes(text) +
                         ": a value is one line, without a '#' after a blank "
                         "and without a backslash at its end");
      return entry;
    }
  } // namespace prm
} // namespace squeal
