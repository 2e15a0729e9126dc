// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/files.h>

#include <squeal/parameters/declarations.h>
#include <squeal/parameters/parameters.h>
#include <squeal/parameters/schema_text.h>
#include <squeal/parameters/text.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <ostream>
#include <sstream>

namespace squeal
{
  namespace
  {
    namespace fs = std::filesystem;

    // Longer names and values are not aligned: the others stay near each other.
    constexpr std::size_t widest_column = 30;

    /** Opens and closes the sections of a parameter file as entries of other
     * sections follow. */
    class SectionWriter
    {
    public:
      explicit SectionWriter(std::ostream &stream)
        : out(stream)
      {
      }

      /** The next entries are in @p section. */
      void
      enter(const std::string &section)
      {
        const std::vector<std::string> names  = prm::split(section, '/');
        std::size_t                    common = 0;
        while (common < std::min(names.size(), open.size()) &&
               names[common] == open[common])
          ++common;
        while (open.size() > common)
          leave();
        for (; common < names.size(); ++common)
          {
            out << '\n' << indent() << "subsection " << names[common] << '\n';
            open.push_back(names[common]);
          }
      }

      void
      set(const std::string &name, const std::string &value)
      {
        out << indent() << "set " << name << " ="
            << (value.empty() ? "" : " " + value) << '\n';
      }

    private:
      void
      leave()
      {
        open.pop_back();
        out << indent() << "end\n";
      }

      std::string
      indent() const
      {
        return std::string(2 * open.size(), ' ');
      }

      std::ostream            &out;
      std::vector<std::string> open;
    };



    /** An absolute file name as seen from the folder of @p file. */
    std::string
    relative_to(const std::string &file, const std::string &name)
    {
      if (name.empty())
        return name;
      const fs::path folder =
        fs::absolute(file).lexically_normal().parent_path();
      return fs::path(name).lexically_proximate(folder).string();
    }

    /** The value of an entry as written to @p file, which names files as seen
     * from its own folder. */
    std::string
    written_value(const prm::Allowed &allowed,
                  const std::string  &file,
                  const std::string  &value)
    {
      if (allowed.kind() != prm::Allowed::Kind::file)
        return value;
      if (!allowed.is_list())
        return relative_to(file, value);
      std::vector<std::string> names = prm::split(value, ',');
      for (std::string &name : names)
        name = relative_to(file, name);
      return prm::join(names, ", ");
    }
  } // namespace



  void
  prm::print_used(const UsedEntries &used_entries,
                  const Schema      &generic,
                  std::ostream      &out)
  {
    std::vector<std::array<std::string, 3>> rows = {
      {{"entry", "value", "default"}}};
    std::string section;
    for (const auto &used : used_entries)
      {
        const Schema::Entry &entry = *generic.find(generic_path(used.first));
        if (used.second == entry.default_value)
          continue;
        if (section_of(used.first) != section)
          {
            section = section_of(used.first);
            rows.push_back({{section, "", ""}});
          }
        rows.push_back({{std::string(section.empty() ? 0 : 2, ' ') + entry.name,
                         used.second,
                         entry.default_value}});
      }

    std::array<std::size_t, 2> width{{0, 0}};
    for (const auto &row : rows)
      if (!row[1].empty() || !row[2].empty())
        for (std::size_t i = 0; i < width.size(); ++i)
          width[i] = std::max(width[i], std::min(row[i].size(), widest_column));
    for (const auto &row : rows)
      {
        std::string line;
        for (std::size_t i = 0; i < width.size(); ++i)
          {
            line += row[i] + "  ";
            if (row[i].size() < width[i])
              line += std::string(width[i] - row[i].size(), ' ');
          }
        line += row[2];
        line.erase(line.find_last_not_of(' ') + 1);
        out << line << '\n';
      }
  }



  void
  prm::write_used(const UsedEntries &used_entries,
                  const Schema      &generic,
                  const std::string &file)
  {
    write_atomically(file, [&](std::ostream &out) {
      out << "# Every entry as used.\n\n";
      SectionWriter writer(out);
      for (const auto &used : used_entries)
        {
          const prm::Schema::Entry &entry =
            *generic.find(generic_path(used.first));
          writer.enter(prm::section_of(used.first));
          writer.set(entry.name,
                     written_value(entry.allowed, file, used.second));
        }
      writer.enter("");
    });
  }



  void
  print_parameters(const Parameters &parameters, std::ostream &out)
  {
    const prm::GenericSchema generic;
    prm::print_used(parameters.used, *generic, out);
  }



  void
  write_used_parameters(const Parameters &parameters, const std::string &file)
  {
    const prm::GenericSchema generic;
    prm::write_used(parameters.used, *generic, file);
  }
} // namespace squeal
