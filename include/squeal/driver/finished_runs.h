// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_driver_finished_runs_h
#define squeal_driver_finished_runs_h

#include <squeal/results/table.h>

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace squeal
{
  /**
   * Rows of runs that an earlier campaign has finished, by their keys, in a
   * JSON file that is rewritten after each run:
   * {key: {"program": version, "row": [...]}}.
   *
   * A row of another version of the program counts too, since most changes of a
   * program change no motion and a campaign may be hours of work; who asks is
   * told of it.
   */
  class FinishedRuns
  {
  public:
    /** Reads @p path if it is there and @p resume; throws InputError if it
     * cannot be read. @p program is the version that goes with new rows. */
    FinishedRuns(const std::string &path,
                 const std::string &program,
                 const bool         resume);

    /** False if there is no run @p key with @p n_columns numbers; 0: with any
     * number of them. */
    bool find(const std::string &key,
              const std::size_t  n_columns,
              std::vector<Cell> &row) const;

    /** The version of the program that made that row; empty if there is none,
     * "unknown" if the row does not say. */
    std::string program_of(const std::string &key) const;

    void add(const std::string &key, const std::vector<Cell> &row);

  private:
    const std::string      path, program;
    nlohmann::ordered_json rows = nlohmann::ordered_json::object();
  };
} // namespace squeal

#endif
