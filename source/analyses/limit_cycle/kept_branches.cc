// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/analyses/limit_cycle/kept_branches.h>
#include <squeal/base/exceptions.h>
#include <squeal/base/root_action.h>
#include <squeal/base/state_files.h>
#include <squeal/parameters/numbers.h>
#include <squeal/run/run_context.h>
#include <squeal/sweep/sweep_grid.h>

namespace squeal
{
  namespace
  {
    const std::string points_of_searches = "searches/n_points";

    /** The path of branch.h5; that of the one before is looked at, too. */
    std::string
    branch_path(RunContext &context)
    {
      const std::string name = "branch.h5";
      const auto        path = [&](const std::string &file) {
        return on_root(context.is_root, [&]() {
          return context.output.state_file(
            file, state_kind::checkpoint, "Output directory");
        });
      };
      path(Checkpoints::name_before(name));
      return path(name);
    }

    Checkpoints
    branch_file(RunContext         &context,
                const PressedModel &pressed,
                const SavedModes   &modes)
    {
      const Parameters &p = context.parameters;
      Fingerprint       fingerprint(p, Fingerprint::Purpose::motion);
      // More points are the same branch, another range has other steps.
      const SweepAxisParameters &axis = p.sweep.axes.front();
      std::string                entries;
      for (std::size_t i = 0; i < axis.entries.size(); ++i)
        entries += (i == 0 ? "" : ", ") + axis.entries[i] + " from " +
                   prm::format_number(entry_value(axis, i, 0.)) + " to " +
                   prm::format_number(entry_value(axis, i, 1.));
      fingerprint.add("axis of the branch", entries);
      fingerprint.add("scale of the branch",
                      SweepGrid(p).is_logarithmic(0) ? "logarithmic"
                                                     : "linear");
      fingerprint.add("modes", std::to_string(pressed.model().n_modes()));
      fingerprint.add("modes, to the last bit", modes.checksum());
      return {
        branch_path(context), fingerprint, "take another output directory"};
    }

    /** What an earlier run has left. */
    NamedNumbers
    earlier_state(const Checkpoints &file, RunContext &context)
    {
      Checkpoints::Found found;
      const std::string  state = on_root(context.is_root, [&]() {
        found = file.find();
        return found.state ? found.state->bytes() : std::string();
      });
      for (const std::string &note : found.notes)
        context.log.warning(note);
      return state.empty() ? NamedNumbers() : NamedNumbers::from_bytes(state);
    }
  } // namespace



  std::optional<SavedModes>
  modes_of_branch(RunContext &context)
  {
    return SavedModes::from_numbers(Checkpoints::group_of_newest(
      branch_path(context), "modes", context.is_root));
  }



  KeptBranches::KeptBranches(RunContext &c, const PressedModel &pressed)
    : context(c)
    , modes(pressed.modes_to_save())
    , file(branch_file(c, pressed, modes))
    , earlier(earlier_state(file, c))
  {
  }

  CycleBranch
  KeptBranches::follow_first(BranchRun &run)
  {
    if (earlier.has("0/n_points"))
      {
        run.restore(earlier);
        context.log.info("  continues from " + file.path() + " with " +
                         std::to_string(run.n_points()) + " points");
      }
    advance(run, [&](NamedNumbers &all) {
      const NamedNumbers found = run.memory();
      for (const auto &[name, values] : found.all())
        all.set(name, values);
    });
    return run.branch();
  }

  CycleBranch
  KeptBranches::follow(BranchRun &run, const std::string &group)
  {
    const std::string sides = group + "/sides";
    if (const NamedNumbers found = kept.group(sides); !found.all().empty())
      run.restore(found);
    advance(run, [&](NamedNumbers &all) { all.set(sides, run.memory()); });
    return run.branch();
  }

  std::string
  KeptBranches::group_of_search(const std::size_t i)
  {
    return "searches/" + std::to_string(i);
  }

  void
  KeptBranches::keep_searches_of(const unsigned int n_points)
  {
    has_searches = earlier.has(points_of_searches) &&
                   earlier.number(points_of_searches) == n_points;
    kept.set(points_of_searches, n_points);
  }

  bool
  KeptBranches::take_over_search(const std::size_t i)
  {
    const std::string  group = group_of_search(i);
    const NamedNumbers found =
      has_searches ? earlier.group(group) : NamedNumbers();
    if (found.all().empty())
      return false;
    kept.set(group, found);
    return true;
  }

  void
  KeptBranches::keep(const std::string &group, const NamedNumbers &numbers)
  {
    kept.set(group, numbers);
  }

  NamedNumbers
  KeptBranches::kept_of(const std::string &group) const
  {
    return kept.group(group);
  }

  void
  KeptBranches::write()
  {
    write(kept);
    if (stop.is_there())
      end();
  }

  void
  KeptBranches::write(const NamedNumbers &numbers) const
  {
    if (!context.is_root)
      return;
    NamedNumbers all = numbers;
    all.set("modes", modes.numbers());
    file.write(all);
  }

  void
  KeptBranches::advance(BranchRun                                 &run,
                        const std::function<void(NamedNumbers &)> &add)
  {
    Timers::Section section(context.timers, "Solve: branch");
    const bool      is_at_its_ends = run.advance([&](const std::size_t n) {
      NamedNumbers all = kept;
      add(all);
      write(all);
      context.log.info("  " + std::to_string(n) + " points of the branch");
      return stop.is_there();
    });
    if (!is_at_its_ends)
      end();
    add(kept);
  }

  void
  KeptBranches::end()
  {
    context.log.info("stopped; the same command continues from " + file.path());
    stop.repeat();
    throw ComputationError("stopped by a signal");
  }
} // namespace squeal
