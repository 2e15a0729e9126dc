// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_analyses_limit_cycle_kept_branches_h
#define squeal_analyses_limit_cycle_kept_branches_h

#include <squeal/base/stop_request.h>
#include <squeal/cycle/branch_run.h>
#include <squeal/model/pressed_model.h>
#include <squeal/run/checkpoints.h>

#include <functional>
#include <optional>
#include <string>

namespace squeal
{
  class RunContext;

  /** The modes that an earlier run has saved its branch in; empty where there
   * is none. Collective. */
  std::optional<SavedModes> modes_of_branch(RunContext &context);

  /**
   * The branch file: all branches and searches of a run, which it has as soon
   * as they are found. What an earlier run has left there is gone on from, to
   * the same bits. The first branch has no group, as it may be the only one.
   */
  class KeptBranches
  {
  public:
    KeptBranches(RunContext &context, const PressedModel &pressed);

    /** @name Both ends of a branch; a signal ends the run after a point */
    //@{
    CycleBranch follow_first(BranchRun &run);
    /** Of the search of @p group. */
    CycleBranch follow(BranchRun &run, const std::string &group);
    //@}

    /** The group of search @p i. */
    static std::string group_of_search(const std::size_t i);
    /** Where an earlier run has followed branches over another number of points
     * its searches are not those of this one. */
    void keep_searches_of(const unsigned int n_points);
    /** Takes search @p i of an earlier run over, if there is one. */
    bool take_over_search(const std::size_t i);

    void         keep(const std::string &group, const NamedNumbers &numbers);
    NamedNumbers kept_of(const std::string &group) const;
    /** Writes what is kept; a signal ends the run then. */
    void write();

  private:
    void write(const NamedNumbers &numbers) const;
    /** @p add puts what the run has found into numbers. */
    void              advance(BranchRun                                 &run,
                              const std::function<void(NamedNumbers &)> &add);
    [[noreturn]] void end();

    RunContext        &context;
    const SavedModes   modes;
    const Checkpoints  file;
    const NamedNumbers earlier;
    NamedNumbers       kept;
    bool               has_searches = false; /**< the earlier run */
    StopRequest        stop;
  };
} // namespace squeal

#endif
