// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/parameters/prm_tree.h>
#include <squeal/parameters/text.h>
#include <squeal/run/settings.h>

#include <algorithm>
#include <cstdlib>

namespace squeal
{
  namespace
  {
    const std::string checks_section = "Result checks/";
    const std::string checks_list    = checks_section + "Checks";

    std::string
    section_of_check(const std::string &name)
    {
      return checks_section + "Check " + name + "/";
    }

    bool
    contains(const std::vector<std::string> &names, const std::string &name)
    {
      return std::find(names.begin(), names.end(), name) != names.end();
    }

    /** Whether an entry says what is written or compared, not what is
     * computed. */
    bool
    changes_no_number(const std::string &path)
    {
      return path == "Output directory" || path == "Overwrite" ||
             prm::starts_with(path, "Output/") ||
             prm::starts_with(path, checks_section);
    }

    /** @p word for a shell. */
    std::string
    shell_quoted(const std::string &word)
    {
      const std::string plain = "abcdefghijklmnopqrstuvwxyz"
                                "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_./+-";
      if (!word.empty() && word.find_first_not_of(plain) == std::string::npos)
        return word;
      std::string result = "'";
      for (const char c : word)
        result += c == '\'' ? std::string("'\\''") : std::string(1, c);
      return result + "'";
    }
  } // namespace



  std::string
  VoidChecks::text() const
  {
    return names.empty()
             ? ""
             : "not checked, as --set '" + cause +
                 "' changes what they expect: " + prm::join(names, ", ");
  }



  VoidChecks
  find_void_checks(const std::vector<ResultCheckParameters> &checks,
                   const std::vector<std::string>           &settings)
  {
    VoidChecks               result;
    std::vector<std::string> paths;
    for (const std::string &setting : settings)
      paths.push_back(prm::parse_override(setting).path);
    // Of two settings of one entry the last one counts.
    for (std::size_t i = 0; i < paths.size() && result.cause.empty(); ++i)
      if (!changes_no_number(paths[i]) &&
          std::count(paths.begin() + i + 1, paths.end(), paths[i]) == 0)
        result.cause = settings[i];
    if (result.cause.empty() || contains(paths, checks_list))
      return {};
    for (const ResultCheckParameters &check : checks)
      if (std::none_of(paths.begin(), paths.end(), [&](const auto &path) {
            return prm::starts_with(path, section_of_check(check.name));
          }))
        result.names.push_back(check.name);
    return result;
  }



  prm::UsedEntries
  without_checks(const prm::UsedEntries         &used,
                 const std::vector<std::string> &names)
  {
    if (names.empty())
      return used;
    prm::UsedEntries result;
    for (const auto &[path, value] : used)
      if (path == checks_list)
        {
          std::vector<std::string> kept;
          for (const std::string &name : prm::split(value, ','))
            if (!contains(names, name))
              kept.push_back(name);
          result.emplace_back(path, prm::join(kept, ", "));
        }
      else if (std::none_of(names.begin(), names.end(), [&](const auto &name) {
                 return prm::starts_with(path, section_of_check(name));
               }))
        result.emplace_back(path, value);
    return result;
  }



  std::vector<ResultCheckParameters>
  without_checks(const std::vector<ResultCheckParameters> &checks,
                 const std::vector<std::string>           &names)
  {
    std::vector<ResultCheckParameters> result;
    for (const ResultCheckParameters &check : checks)
      if (!contains(names, check.name))
        result.push_back(check);
    return result;
  }



  std::string
  command_of_run(const std::string              &file,
                 const std::vector<std::string> &settings,
                 const unsigned int              n_ranks)
  {
    // The launcher says by which name it was called, as it is installed or not.
    const char *launcher = std::getenv("SQUEAL_LAUNCHER");
    std::string command  = (launcher ? launcher : "./squeal") +
                          std::string(" run ") + shell_quoted(file);
    if (n_ranks > 1)
      command += " -np " + std::to_string(n_ranks);
    for (const std::string &setting : settings)
      command += " \\\n  --set " + shell_quoted(setting);
    return command;
  }
} // namespace squeal
