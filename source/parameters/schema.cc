// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>

#include <squeal/parameters/names.h>
#include <squeal/parameters/schema.h>
#include <squeal/parameters/text.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <filesystem>

namespace squeal
{
  namespace prm
  {
    namespace
    {
      /** What is wrong with a value, after "is not allowed". */
      std::string
      remedy(const Schema::Entry &entry, const std::string &value)
      {
        if (entry.allowed.words() == Allowed::names().words())
          {
            const std::string fault = fault_of_names(split(value, ','));
            if (!fault.empty())
              return fault;
          }
        const std::string units =
          entry.units == "none" ? "" : " (" + entry.units_text() + ")";
        return "give " + entry.allowed.words() + units +
               did_you_mean(value, entry.allowed.choices());
      }



      /** The path in a list of files whose comma takes it apart; empty if there
       * is none: the folder that the names start from, or some neighbours in
       * the list that are a file together. */
      std::string
      path_with_comma(const RawEntry &raw)
      {
        namespace fs                              = std::filesystem;
        constexpr std::size_t          most_parts = 4;
        const std::vector<std::string> names      = split(raw.value, ',');
        std::error_code                ignored;
        for (std::size_t i = 0; i < names.size(); ++i)
          {
            std::string joined = names[i];
            if (fs::path(joined).is_relative() &&
                raw.directory.find(',') != std::string::npos)
              return raw.directory;
            const std::size_t end = std::min(names.size(), i + most_parts);
            for (std::size_t j = i + 1; j < end; ++j)
              {
                joined += "," + names[j];
                if (fs::exists(fs::path(raw.directory) / joined, ignored))
                  return joined;
              }
          }
        return "";
      }



      void
      refuse_paths_with_commas(const Allowed &allowed, const RawEntry &raw)
      {
        if (allowed.kind() != Allowed::Kind::file || !allowed.is_list())
          return;
        const std::string path = path_with_comma(raw);
        if (!path.empty())
          throw InputError(raw.location.text() + ": " + in_quotes(raw.path) +
                           " is a list separated by commas: it cannot name "
                           "files by a path with a comma, " +
                           in_quotes(path) + "; rename it");
      }
    } // namespace



    std::string
    Schema::Entry::units_text() const
    {
      return units_per_area.empty() ? units
                                    : units + ", per area " + units_per_area;
    }

    std::string
    Schema::Entry::path() const
    {
      return path_of(section, name);
    }



    Schema::Schema()
      : handler(std::make_unique<dealii::ParameterHandler>())
      , section_list{{"", ""}}
    {
    }



    Schema::~Schema() = default;



    std::string
    Schema::section_path() const
    {
      return join(open_sections, "/");
    }



    void
    Schema::enter_section(const std::string &name,
                          const std::string &documentation)
    {
      handler->enter_subsection(name);
      open_sections.push_back(name);
      section_list.push_back({section_path(), documentation});
    }



    void
    Schema::leave_section()
    {
      handler->leave_subsection();
      open_sections.pop_back();
    }



    Schema::Entry &
    Schema::declare(Entry entry)
    {
      Assert(entry.section == section_path(), dealii::ExcInternalError());
      Assert(entry_index.count(entry.path()) == 0, dealii::ExcInternalError());
      handler->declare_entry(entry.name,
                             entry.default_value,
                             entry.allowed.pattern(),
                             entry.documentation + " Units: " + entry.units +
                               ".");
      entry_index[entry.path()] = entry_list.size();
      entry_list.push_back(std::move(entry));
      return entry_list.back();
    }



    void
    Schema::set(const RawEntry &raw)
    {
      const Entry &entry = *find(raw.path);
      refuse_paths_with_commas(entry.allowed, raw);
      const std::optional<std::string> value =
        entry.allowed.canonical(raw.value, raw.directory);
      if (!value || !entry.allowed.matches(*value))
        throw InputError(raw.location.text() + ": " + in_quotes(raw.path) +
                         " = " + in_quotes(raw.value) + " is not allowed; " +
                         remedy(entry, raw.value));

      const std::vector<std::string> sections = split(entry.section, '/');
      for (const std::string &section : sections)
        handler->enter_subsection(section);
      handler->set(entry.name, *value);
      for (std::size_t i = 0; i < sections.size(); ++i)
        handler->leave_subsection();
    }



    std::string
    Schema::value(const Entry &entry) const
    {
      return handler->get(split(entry.section, '/'), entry.name);
    }



    void
    Schema::assign() const
    {
      for (const Entry &entry : entry_list)
        entry.assign(value(entry));
    }



    const std::vector<Schema::Entry> &
    Schema::entries() const
    {
      return entry_list;
    }



    const std::vector<Schema::Section> &
    Schema::sections() const
    {
      return section_list;
    }



    const Schema::Entry *
    Schema::find(const std::string &path) const
    {
      const auto index = entry_index.find(path);
      return index == entry_index.end() ? nullptr : &entry_list[index->second];
    }



    bool
    Schema::has_section(const std::string &path) const
    {
      return std::any_of(section_list.begin(),
                         section_list.end(),
                         [&path](const Section &s) { return s.path == path; });
    }



    std::vector<std::string>
    Schema::entries_of(const std::string &section) const
    {
      std::vector<std::string> names;
      for (const Entry &entry : entry_list)
        if (entry.section == section)
          names.push_back(entry.name);
      return names;
    }



    std::vector<std::string>
    Schema::sections_of(const std::string &section) const
    {
      std::vector<std::string> names;
      for (const Section &s : section_list)
        if (!s.path.empty() && section_of(s.path) == section)
          names.push_back(entry_of(s.path));
      return names;
    }
  } // namespace prm
} // namespace squeal
