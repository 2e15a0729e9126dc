// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_run_settings_h
#define squeal_run_settings_h

#include <squeal/parameters/analysis_parameters.h>
#include <squeal/parameters/schema_text.h>

#include <string>
#include <vector>

namespace squeal
{
  /** What the command line says of a run beside its file. */
  struct RunOptions
  {
    std::vector<std::string> settings; /**< "Section/Entry = value" of --set */
    bool                     is_quiet = false;
  };

  /** Result checks that do not hold for a run any more. */
  struct VoidChecks
  {
    std::vector<std::string> names;
    std::string              cause; /**< the setting to blame */

    /** One line for a person, empty where there are none. */
    std::string text() const;
  };

  /**
   * The @p checks that @p settings have made void. Any setting does, for all of
   * them, but one of section "Output", of "Output directory" or of "Overwrite",
   * which change no number. A check stays where a setting speaks of it: of an
   * entry in its section or of the list of checks.
   */
  VoidChecks find_void_checks(const std::vector<ResultCheckParameters> &checks,
                              const std::vector<std::string> &settings);

  /** The entries of a run without those checks: what is written as
   * parameters_used.prm, so that it repeats the run by itself. */
  prm::UsedEntries without_checks(const prm::UsedEntries         &used,
                                  const std::vector<std::string> &names);

  /** The same for the checks themselves. */
  std::vector<ResultCheckParameters> without_checks(
    const std::vector<ResultCheckParameters> &checks,
    const std::vector<std::string>           &names);

  /** The command that repeats a run from @p file, as typed in a shell, a line
   * for each setting. */
  std::string command_of_run(const std::string              &file,
                             const std::vector<std::string> &settings,
                             unsigned int                    n_ranks);
} // namespace squeal

#endif
