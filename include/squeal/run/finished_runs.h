// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_run_finished_runs_h
#define squeal_run_finished_runs_h

#include <squeal/results/table.h>
#include <squeal/run/fingerprint.h>

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace squeal
{
  /**
   * Rows of runs that an earlier campaign has finished, in a JSON file that is
   * rewritten after each run: each with its name ("row", "phases"), the text of
   * its fingerprint and a checksum of all three. Rows of other runs, of another
   * program say, stay in the file.
   */
  class FinishedRuns
  {
  public:
    /** @p content: that of the file @p path; empty where there is none. Throws
     * InputError, and leaves the file as it is, if it cannot be understood or a
     * row is not as it was written. */
    FinishedRuns(const std::string &path, const std::string &content);

    /** The row @p name of the run of @p fingerprint; false if there is none with
     * @p n_columns numbers (0: with any number of them). */
    bool find(const Fingerprint &fingerprint,
              const std::string &name,
              const std::size_t  n_columns,
              std::vector<Cell> &row) const;

    /** Adds a row or replaces it and writes the file. A row with an infinite
     * number, which JSON does not know, is not kept. */
    void add(const Fingerprint       &fingerprint,
             const std::string       &name,
             const std::vector<Cell> &row);

    std::size_t n_rows() const;

    /** Of the run in the file that is most like that of @p fingerprint: how that
     * differs from it, see Fingerprint::difference(). Empty without runs. */
    std::string nearest_difference(const Fingerprint &fingerprint) const;

  private:
    const std::string                   path;
    std::vector<nlohmann::ordered_json> rows;
  };
} // namespace squeal

#endif
