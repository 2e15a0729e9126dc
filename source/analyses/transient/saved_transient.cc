// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/analyses/transient/saved_transient.h>
#include <squeal/analyses/transient/transient_results.h>
#include <squeal/base/exceptions.h>
#include <squeal/base/root_action.h>
#include <squeal/base/run_log.h>
#include <squeal/base/state_files.h>
#include <squeal/run/run_context.h>

#include <filesystem>

namespace squeal
{
  namespace fs = std::filesystem;

  namespace
  {
    constexpr const char *way_out =
      "; move the checkpoint away or set Transient/Resume = false";

    /** The path of the checkpoint; those of all other files are looked at, too.
     */
    std::string
    checkpoint_path(RunContext &context)
    {
      const std::string &asked = context.parameters.transient.checkpoint_file;
      const std::string  name  = asked.empty() ? "checkpoint.h5" : asked;
      const auto         path = [&](const std::string &file, const char *kind) {
        return on_root(context.is_root, [&]() {
          return context.output.state_file(
            file, kind, "Transient/Checkpoint file");
        });
      };
      path(Checkpoints::name_before(name), state_kind::checkpoint);
      path(HistoryStream::samples_name(name), state_kind::samples);
      path(HistoryStream::changes_name(name), state_kind::changes);
      return path(name, state_kind::checkpoint);
    }
  } // namespace



  SavedTransient::SavedTransient(const PressedModel &pressed,
                                 RunContext         &context)
    : checkpoint(checkpoint_path(context))
    , modes(pressed.modes_to_save())
    , stream(context.is_root ? make_history_stream(pressed.nodes(), checkpoint)
                             : nullptr)
  {
  }

  SavedTransient::~SavedTransient()
  {
    std::error_code error;
    if (stream && !fs::exists(checkpoint, error) &&
        !fs::exists(Checkpoints::name_before(checkpoint), error))
      stream->remove();
  }



  std::optional<SavedModes>
  SavedTransient::earlier_modes(RunContext &context)
  {
    if (!context.parameters.transient.resume)
      return std::nullopt;
    return SavedModes::from_numbers(Checkpoints::group_of_newest(
      checkpoint_path(context), "modes", context.is_root));
  }

  HistoryStream *
  SavedTransient::history()
  {
    return stream.get();
  }

  const std::string &
  SavedTransient::path() const
  {
    return checkpoint;
  }



  Checkpoints::Found
  SavedTransient::find(const bool resume)
  {
    Checkpoints::Found found = checkpoints->find(resume);
    if (found.state)
      {
        try
          {
            stream->restore(found.state->group("history"));
          }
        catch (const InputError &e)
          {
            throw InputError("history of the checkpoint '" + found.file +
                             "': " + e.what() + way_out);
          }
        return found;
      }
    // Without a checkpoint of its own nothing goes on from a history.
    std::error_code error;
    for (const std::string &path : {HistoryStream::samples_name(checkpoint),
                                    HistoryStream::changes_name(checkpoint)})
      if (!found.notes.empty() && fs::exists(path, error))
        found.notes.push_back("history '" + path +
                              "' of that checkpoint is kept as '" +
                              set_aside(path) + "'");
    return found;
  }



  void
  SavedTransient::resume(TransientRun &run, RunContext &context)
  {
    const Parameters &p = context.parameters;
    Fingerprint       fingerprint(p, Fingerprint::Purpose::motion);
    run.describe(fingerprint);
    // Of all unknowns the motion does not hang on modes.
    if (!run.moves_all_unknowns())
      fingerprint.add("modes, to the last bit", modes.checksum());
    checkpoints.emplace(checkpoint, fingerprint);
    Checkpoints::Found found;
    const std::string  state = on_root(context.is_root, [&]() {
      found = find(p.transient.resume);
      return found.state ? found.state->bytes() : std::string();
    });
    for (const std::string &note : found.notes)
      context.log.warning(note);
    if (state.empty())
      return;
    found.file = from_root(found.file);
    try
      {
        run.restore(NamedNumbers::from_bytes(state));
      }
    catch (const InputError &e)
      {
        throw InputError("checkpoint '" + found.file +
                         "' does not fit this run: " + e.what() +
                         "; move it away or set Transient/Resume = false");
      }
    context.log.info("  continues from " + found.file + " at step " +
                     std::to_string(static_cast<long>(run.record().n_steps)));
  }



  void
  SavedTransient::write(const TransientRun &run)
  {
    if (!stream)
      return;
    NamedNumbers memory = run.memory();
    memory.set("history", stream->memory());
    memory.set("modes", modes.numbers());
    checkpoints->write(memory);
  }



  void
  SavedTransient::remove()
  {
    if (!stream)
      return;
    checkpoints->remove();
    stream->remove();
  }
} // namespace squeal
