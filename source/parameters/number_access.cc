// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>

#include <squeal/parameters/declarations.h>
#include <squeal/parameters/names.h>
#include <squeal/parameters/number_access.h>
#include <squeal/parameters/numbers.h>
#include <squeal/parameters/prm_tree.h>
#include <squeal/parameters/text.h>

#include <algorithm>
#include <map>

namespace squeal
{
  namespace
  {
    /** An entry and what is in it: one number, or several of which one is
     * meant. */
    struct NumberEntry
    {
      std::string              path;
      std::vector<std::string> values;
      std::size_t              component = 0;
    };



    [[noreturn]] void
    refuse_unknown(const Parameters &parameters, const std::string &path)
    {
      std::vector<std::string> paths, same_section;
      for (const auto &entry : parameters.used)
        {
          paths.push_back(entry.first);
          if (prm::section_of(entry.first) == prm::section_of(path))
            same_section.push_back(entry.first);
        }
      throw InputError(
        "unknown entry " + prm::in_quotes(path) +
        prm::did_you_mean(path, same_section.empty() ? paths : same_section));
    }



    /** Splits "Entry[2]" into the entry and the position from 1; 0 if there is
     * none. */
    std::pair<std::string, std::size_t>
    split_component(const std::string &path)
    {
      const std::size_t open = path.rfind('[');
      if (open == std::string::npos || path.back() != ']')
        return {path, 0};
      const std::optional<double> number =
        prm::parse_number(path.substr(open + 1, path.size() - open - 2));
      if (!number || *number < 1. || *number > 1e6 ||
          *number != static_cast<double>(static_cast<std::size_t>(*number)))
        throw InputError(prm::in_quotes(path) +
                         ": the components of a list are counted from [1]");
      return {prm::trim(path.substr(0, open)),
              static_cast<std::size_t>(*number)};
    }



    NumberEntry
    find_number(const Parameters &parameters, const std::string &text)
    {
      NumberEntry entry;
      std::size_t position           = 0;
      std::tie(entry.path, position) = split_component(prm::normal_path(text));

      const auto used = std::find_if(parameters.used.begin(),
                                     parameters.used.end(),
                                     [&entry](const auto &candidate) {
                                       return candidate.first == entry.path;
                                     });
      if (used == parameters.used.end())
        refuse_unknown(parameters, entry.path);

      entry.values = prm::split(used->second, ',');
      const bool is_numbers =
        !entry.values.empty() &&
        std::all_of(entry.values.begin(),
                    entry.values.end(),
                    [](const std::string &value) {
                      return prm::parse_number(value).has_value();
                    });
      const std::string shown = "'" + entry.path + " = " + used->second + "'";
      if (!is_numbers)
        throw InputError(shown + " is not a number");
      if (entry.values.size() > 1 && position == 0)
        throw InputError(shown + " is a list: choose one number, for example " +
                         prm::in_quotes(entry.path + "[1]"));
      if (position > entry.values.size())
        throw InputError(shown + " has no component [" +
                         std::to_string(position) + "]");
      entry.component = position == 0 ? 0 : position - 1;
      return entry;
    }
  } // namespace



  double
  get_number(const Parameters &parameters, const std::string &path)
  {
    const NumberEntry entry = find_number(parameters, path);
    return prm::parse_number(entry.values[entry.component]).value();
  }



  std::map<std::string, std::string>
  changed_entries(const Parameters               &parameters,
                  const std::vector<std::string> &paths,
                  const std::vector<double>      &values)
  {
    // Components of one list change one after the other.
    std::map<std::string, std::vector<std::string>> changed;
    for (std::size_t i = 0; i < paths.size(); ++i)
      {
        const NumberEntry entry = find_number(parameters, paths[i]);
        changed.emplace(entry.path, entry.values)
          .first->second[entry.component] = prm::format_number(values.at(i));
      }
    std::map<std::string, std::string> result;
    for (const auto &[path, numbers] : changed)
      result[path] = prm::join(numbers, ", ");
    return result;
  }



  Parameters
  with_values(const Parameters               &parameters,
              const std::vector<std::string> &paths,
              const std::vector<double>      &values)
  {
    const auto   entries = changed_entries(parameters, paths, values);
    prm::PrmTree tree;
    for (const auto &[path, text] : parameters.used)
      {
        const auto found = entries.find(path);
        if (found == entries.end())
          tree.entries.push_back({path, text, {parameters.file, 0}, ""});
        else
          tree.entries.push_back({path,
                                  found->second,
                                  {parameters.file + ", changed value", 0},
                                  ""});
      }
    Parameters changed = prm::parse_tree(std::move(tree), parameters.file);
    changed.notes      = parameters.notes;
    changed.check();
    return changed;
  }

  Parameters
  with_value(const Parameters  &parameters,
             const std::string &path,
             const double       value)
  {
    return with_values(parameters, {path}, {value});
  }



  struct NumberSetter::Target
  {
    const prm::Schema::Entry *entry;
    /** Of the whole entry; the components of one list share them, so that none
     * takes back what another one sets. */
    std::shared_ptr<std::vector<std::string>> values;
    std::size_t                               component;
  };

  NumberSetter::NumberSetter(const Parameters               &parameters,
                             const std::vector<std::string> &paths)
    : changed(parameters)
    , schema(std::make_unique<prm::Schema>())
  {
    prm::declare_parameters(*schema, changed);
    std::map<std::string, std::shared_ptr<std::vector<std::string>>> lists;
    for (const auto &path : paths)
      {
        const NumberEntry entry = find_number(parameters, path);
        auto             &list  = lists[entry.path];
        if (!list)
          list = std::make_shared<std::vector<std::string>>(entry.values);
        targets.push_back({schema->find(entry.path), list, entry.component});
      }
  }

  NumberSetter::~NumberSetter() = default;

  const SceneParameters &
  NumberSetter::scene(const std::vector<double> &values)
  {
    for (std::size_t i = 0; i < targets.size(); ++i)
      {
        const Target &target               = targets[i];
        (*target.values)[target.component] = prm::format_number(values.at(i));
        target.entry->assign(prm::join(*target.values, ", "));
      }
    return changed.scene;
  }
} // namespace squeal
