// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_analyses_transient_saved_transient_h
#define squeal_analyses_transient_saved_transient_h

#include <squeal/analyses/transient/transient_run.h>
#include <squeal/run/checkpoints.h>

#include <memory>
#include <optional>
#include <string>

namespace squeal
{
  class RunContext;

  /**
   * What a transient leaves in the output directory while it runs: its
   * checkpoints and the history of its contacts so far, which a checkpoint
   * stands for up to its own time. The root writes them; other ranks have
   * neither.
   */
  class SavedTransient
  {
  public:
    /** Only looks at the names. Throws InputError where a file of one of them
     * is there that squeal has not written. */
    SavedTransient(const PressedModel &pressed, RunContext &context);
    /** Removes a history that no checkpoint stands for. */
    ~SavedTransient();
    SavedTransient(const SavedTransient &)            = delete;
    SavedTransient &operator=(const SavedTransient &) = delete;

    /** The modes that an earlier run has saved its motion in; empty where there
     * is none. Collective. */
    static std::optional<SavedModes> earlier_modes(RunContext &context);

    /** What the run hands its samples to; null on other ranks than the root. */
    HistoryStream *history();

    /** Takes over what an earlier run has left; all ranks do as the root.
     * Files of other runs are put aside, and damaged ones are refused. */
    void resume(TransientRun &run, RunContext &context);

    /** A checkpoint of @p run. */
    void write(const TransientRun &run);

    /** For a run that has ended. */
    void remove();

    /** Of the checkpoint. */
    const std::string &path() const;

  private:
    /** Looks for a checkpoint of this run, with its history. */
    Checkpoints::Found find(const bool resume);

    const std::string              checkpoint;
    const SavedModes               modes;
    std::unique_ptr<HistoryStream> stream;
    std::optional<Checkpoints>     checkpoints; /**< from resume() on */
  };
} // namespace squeal

#endif
