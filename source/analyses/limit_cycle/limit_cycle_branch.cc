// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/analyses/limit_cycle/limit_cycle_branch.h>

#include <squeal/base/exceptions.h>
#include <squeal/base/number_text.h>
#include <squeal/base/root_action.h>
#include <squeal/base/state_files.h>
#include <squeal/base/stop_request.h>
#include <squeal/cycle/branch_run.h>
#include <squeal/parameters/numbers.h>
#include <squeal/run/checkpoints.h>
#include <squeal/run/run_context.h>
#include <squeal/sweep/sweep_grid.h>

namespace squeal
{
  namespace
  {
    /** Steady sliding at one value of the parameter and the motions about it.
     */
    struct BranchMap
    {
      BranchMap(const SteadyModel &a)
        : about(a)
        , map(period_map_of(about))
      {
      }
      const SteadyModel about;
      const PeriodMap   map;
    };

    /** The last two that were asked for are kept. */
    class BranchMaps
    {
    public:
      BranchMaps(RunContext &c, const PressedModel &p)
        : context(c)
        , pressed(p)
        , grid(c.parameters)
      {
      }

      std::shared_ptr<const PeriodMap>
      operator()(const double parameter)
      {
        for (const unsigned int i : {0u, 1u})
          if (kept[i] && kept_at[i] == parameter)
            return {kept[i], &kept[i]->map};
        kept[1]    = kept[0];
        kept_at[1] = kept_at[0];
        SweepPoint at(1);
        at << parameter;
        kept[0] = std::make_shared<const BranchMap>(
          pressed.with_friction(friction_sizes(grid.scene(at).contacts))
            .steady(context.parameters.preload.tolerance, context.timers));
        kept_at[0] = parameter;
        return {kept[0], &kept[0]->map};
      }

    private:
      RunContext                      &context;
      const PressedModel              &pressed;
      const SweepGrid                  grid;
      std::shared_ptr<const BranchMap> kept[2];
      double                           kept_at[2] = {-1., -1.};
    };

    BranchSettings
    settings_of(const Parameters &p, const CycleResult &start)
    {
      const SweepAxisParameters &axis = p.sweep.axes.front();
      BranchSettings             settings;
      settings.lower    = axis.from.front();
      settings.upper    = axis.to.front();
      settings.n_points = axis.number;
      settings.shooting = {
        p.limit_cycle.steps, p.limit_cycle.iterations, p.limit_cycle.tolerance};
      settings.multiplier_error = start.multipliers.uncertainty();
      return settings;
    }

    Checkpoints
    branch_file(RunContext           &context,
                const BranchSettings &settings,
                const PressedModel   &pressed)
    {
      const Parameters &p = context.parameters;
      Fingerprint       fingerprint(p, Fingerprint::Purpose::motion);
      // More points are the same branch, another range has other steps.
      fingerprint.add("range of the branch",
                      prm::format_number(settings.lower) + " to " +
                        prm::format_number(settings.upper));
      fingerprint.add("axis of the branch",
                      p.sweep.axes.front().entries.front());
      fingerprint.add("modes", std::to_string(pressed.model().n_modes()));
      const std::string name = "branch.h5";
      const auto        path = [&](const std::string &file) {
        return on_root(context.is_root, [&]() {
          return context.output.state_file(
            file, state_kind::checkpoint, "Output directory");
        });
      };
      path(Checkpoints::name_before(name));
      return {path(name), fingerprint, "take another output directory"};
    }

    void
    resume(BranchRun &run, const Checkpoints &file, RunContext &context)
    {
      Checkpoints::Found found;
      const std::string  state = on_root(context.is_root, [&]() {
        found = file.find();
        return found.state ? found.state->bytes() : std::string();
      });
      for (const std::string &note : found.notes)
        context.log.warning(note);
      if (state.empty())
        return;
      run.restore(NamedNumbers::from_bytes(state));
      context.log.info("  continues from " + file.path() + " with " +
                       std::to_string(run.n_points()) + " points");
    }
  } // namespace



  void
  require_on_axis(const Parameters &p)
  {
    const SweepAxisParameters &axis = p.sweep.axes.front();
    const double               here = get_number(p, axis.entries.front());
    if (here < axis.from.front() || here > axis.to.front())
      throw InputError("Sweep/Axis " + axis.name + ": the scene's " +
                       axis.entries.front() + " = " + rounded_text(here, 6) +
                       " is outside: the branch starts there");
  }



  CycleBranch
  branch_of(RunContext         &context,
            const PressedModel &pressed,
            const CycleResult  &start)
  {
    const Parameters    &p        = context.parameters;
    const BranchSettings settings = settings_of(p, start);
    const auto           maps = std::make_shared<BranchMaps>(context, pressed);
    BranchRun run([maps](const double parameter) { return (*maps)(parameter); },
                  start.motion,
                  get_number(p, p.sweep.axes.front().entries.front()),
                  settings);
    const Checkpoints file = branch_file(context, settings, pressed);
    Timers::Section   section(context.timers, "Solve: branch");
    resume(run, file, context);
    StopRequest stop;
    const bool  is_at_its_ends = run.advance([&](const std::size_t n) {
      if (context.is_root)
        file.write(run.memory());
      context.log.info("  " + std::to_string(n) + " points of the branch");
      return stop.is_there();
    });
    if (!is_at_its_ends)
      {
        context.log.info("stopped; the same command continues from " +
                         file.path());
        stop.repeat();
        throw ComputationError("stopped by a signal");
      }
    return run.branch();
  }
} // namespace squeal
