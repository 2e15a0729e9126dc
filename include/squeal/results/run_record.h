// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_results_run_record_h
#define squeal_results_run_record_h

#include <squeal/base/timers.h>
#include <squeal/results/result_checks.h>

#include <string>
#include <utility>
#include <vector>

namespace squeal
{
  /**
   * All that is to be known about a run beside its result files: written as
   * run.json, shown by the report, read by the comparison of two runs.
   */
  struct RunRecord
  {
    using Pairs = std::vector<std::pair<std::string, std::string>>;

    /** Version of the layout of run.json; a reader refuses any other. */
    static constexpr int format_version = 1;

    Pairs       versions; /**< "squeal", "deal.II", ... and their versions */
    std::string analysis;
    std::string scene;
    std::string parameter_file;
    /** "Section/Entry = value" of each --set */
    std::vector<std::string> settings;
    Pairs                    parameters; /**< every entry as used */
    Pairs       figures; /**< named results, "unstable pairs" "2" */
    std::size_t n_dofs = 0;
    std::vector<std::pair<std::string, std::size_t>> dofs_of_bodies;
    unsigned int                                     n_ranks = 1;

    std::vector<Timers::Entry> timings;
    double                     total_wall     = 0.; /**< s */
    double                     total_cpu      = 0.; /**< s */
    double                     peak_memory_mb = 0.;

    std::vector<std::string> warnings;
    std::vector<ResultCheck> checks;
    std::vector<std::string> void_checks; /**< left out, by name */
    std::string              void_cause; /**< the setting that made them void */
    std::vector<std::string> files;      /**< names in the output directory */

    /** Takes times and memory as of now. */
    void take_timings(const Timers &timers);
  };

  /** Writes run.json. */
  void write_run_record(const RunRecord &record, const std::string &path);

  /** Reads run.json. Throws InputError naming the file when it is missing, no
   * JSON, of an unknown format version, or lacks an entry. */
  RunRecord read_run_record(const std::string &path);
} // namespace squeal

#endif
