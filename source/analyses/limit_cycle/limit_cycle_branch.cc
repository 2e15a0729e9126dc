// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/analyses/limit_cycle/branch_models.h>
#include <squeal/analyses/limit_cycle/limit_cycle_branch.h>

#include <squeal/base/exceptions.h>
#include <squeal/base/number_text.h>
#include <squeal/base/root_action.h>
#include <squeal/base/state_files.h>
#include <squeal/base/stop_request.h>
#include <squeal/cycle/branch_run.h>
#include <squeal/parameters/number_access.h>
#include <squeal/parameters/numbers.h>
#include <squeal/parameters/text.h>
#include <squeal/run/checkpoints.h>
#include <squeal/run/run_context.h>
#include <squeal/sweep/sweep_grid.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace squeal
{
  namespace
  {
    /** Numbers that differ by less, over their size, are the same. */
    constexpr double rounding = 1e-12;

    BranchSettings
    settings_of(const Parameters &p, const CycleResult &start)
    {
      const SweepAxisParameters &axis = p.sweep.axes.front();
      // The grid of a single point has no range.
      const auto coordinate =
        [is_log = SweepGrid(p).is_logarithmic(0)](const double value) {
          return is_log ? std::log10(value) : value;
        };
      BranchSettings settings;
      settings.lower    = coordinate(axis.from.front());
      settings.upper    = coordinate(axis.to.front());
      settings.n_points = axis.number;
      settings.shooting = {
        p.limit_cycle.steps, p.limit_cycle.iterations, p.limit_cycle.tolerance};
      settings.multiplier_error = start.multipliers.uncertainty();
      return settings;
    }

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

    bool
    is_same(const Eigen::MatrixXd &a, const Eigen::MatrixXd &b)
    {
      return a.rows() == b.rows() && a.cols() == b.cols() &&
             (a - b).norm() <= rounding * a.norm();
    }

    /** Whether two models under their laws move alike; steady sliding is that
     * of the model, whose gaps and loads it has set. */
    bool
    move_alike(const PeriodMap &a, const PeriodMap &b)
    {
      const ReducedContactModel &x = a.reduced_model(), &y = b.reduced_model();
      const CycleFriction       &of_x = a.law_of_friction(),
                          &of_y       = b.law_of_friction();
      const auto all =
        [](const std::vector<std::pair<Eigen::MatrixXd, Eigen::MatrixXd>>
             &pairs) {
          return std::all_of(pairs.begin(), pairs.end(), [](const auto &pair) {
            return is_same(pair.first, pair.second);
          });
        };
      return std::abs(of_x.speed - of_y.speed) <=
               rounding * std::abs(of_x.speed) &&
             all({{of_x.kinetic, of_y.kinetic},
                  {of_x.at_rest, of_y.at_rest},
                  {x.omega_squared, y.omega_squared},
                  {x.damping, y.damping},
                  {x.damping_coupling, y.damping_coupling},
                  {x.participation, y.participation},
                  {x.flexibility, y.flexibility},
                  {x.load, y.load},
                  {x.load_motion, y.load_motion},
                  {x.initial_gap, y.initial_gap},
                  {x.speed_ratio, y.speed_ratio}});
    }

    /** Refuses an axis along which nothing changes. */
    void
    require_effect(const PeriodMaps     &maps,
                   const BranchSettings &settings,
                   const double          here,
                   const Parameters     &p)
    {
      const auto start = maps(here);
      for (const double end : {settings.lower, settings.upper})
        if (const auto there = maps.find(end);
            !there || !move_alike(*start, *there))
          return;
      const SweepAxisParameters &axis = p.sweep.axes.front();
      throw InputError("Sweep/Axis " + axis.name +
                       ": neither the model nor its "
                       "steady sliding nor its friction changes along " +
                       prm::join(axis.entries, ", ") +
                       ": every point of the branch would be the same");
    }

    /** The coordinate of the scene's own value. */
    double
    place_on_axis(const Parameters &p)
    {
      const double here = get_number(p, p.sweep.axes.front().entries.front());
      return SweepGrid(p).is_logarithmic(0) ? std::log10(here) : here;
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
    // At both ends the scene has to be one that could stand in the file.
    for (const double share : {0., 1.})
      {
        std::vector<double> values;
        for (std::size_t i = 0; i < axis.entries.size(); ++i)
          values.push_back(entry_value(axis, i, share));
        try
          {
            with_values(p, axis.entries, values);
          }
        catch (const InputError &e)
          {
            throw InputError("Sweep/Axis " + axis.name + ": at the " +
                             (share == 0. ? "lower" : "upper") +
                             " end: " + e.what());
          }
      }
    // Other entries go along with the first one, from the scene's value of it.
    const std::vector<double> there =
      SweepGrid(p).values(SweepPoint::Constant(1, place_on_axis(p)));
    for (std::size_t i = 0; i < axis.entries.size(); ++i)
      if (const double value = get_number(p, axis.entries[i]);
          !(std::abs(value - there[i]) <= 1e-9 * std::abs(there[i])))
        throw InputError("Sweep/Axis " + axis.name + ": the scene's " +
                         axis.entries[i] + " = " + rounded_text(value, 6) +
                         ", but the axis has " + rounded_text(there[i], 6) +
                         " where the branch starts");
  }



  std::optional<SavedModes>
  modes_of_branch(RunContext &context)
  {
    return SavedModes::from_numbers(Checkpoints::group_of_newest(
      branch_path(context), "modes", context.is_root));
  }

  CycleBranch
  branch_of(RunContext         &context,
            const PressedModel &pressed,
            const CycleResult  &start)
  {
    const Parameters    &p        = context.parameters;
    const BranchSettings settings = settings_of(p, start);
    const PeriodMaps     maps     = branch_maps(context, pressed);
    require_effect(maps, settings, place_on_axis(p), p);
    BranchRun         run(maps, start.motion, place_on_axis(p), settings);
    const SavedModes  modes = pressed.modes_to_save();
    const Checkpoints file  = branch_file(context, pressed, modes);
    Timers::Section   section(context.timers, "Solve: branch");
    resume(run, file, context);
    StopRequest stop;
    const bool  is_at_its_ends = run.advance([&](const std::size_t n) {
      if (context.is_root)
        {
          NamedNumbers memory = run.memory();
          memory.set("modes", modes.numbers());
          file.write(memory);
        }
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
    CycleBranch     branch = run.branch();
    const SweepGrid grid(p);
    for (BranchPoint &point : branch.points)
      point.parameter = grid.value(0, point.parameter);
    return branch;
  }
} // namespace squeal
