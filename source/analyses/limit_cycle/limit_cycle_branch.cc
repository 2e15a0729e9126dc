// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/analyses/limit_cycle/limit_cycle_branch.h>

#include <squeal/analyses/limit_cycle/kept_branches.h>
#include <squeal/base/exceptions.h>
#include <squeal/base/number_text.h>
#include <squeal/parameters/number_access.h>
#include <squeal/parameters/text.h>
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
    /** Along the branch where every point has models of its own: an iteration
     * takes two of them, and most of a run went into steps shorter than this
     * behind its last point. */
    constexpr double smallest_step_with_models = 1e-3;

    BranchSettings
    settings_of(const Parameters &p)
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
      return settings;
    }

    /** Searches from one end of the axis to the other. */
    class AxisRun
    {
    public:
      AxisRun(RunContext          &c,
              const BranchModels  &m,
              const BranchSettings s,
              KeptBranches        &k,
              BranchDiagram       &d)
        : context(c)
        , models(m)
        , settings(s)
        , grid(c.parameters)
        , kept(k)
        , diagram(d)
      {
        settings.is_of_another = [&](const BranchPoint &point) {
          return std::any_of(
            diagram.branches.begin(),
            diagram.branches.end(),
            [&](const CycleBranch &branch) { return lies_on(branch, point); });
        };
      }

      void
      run()
      {
        const unsigned int n = context.parameters.limit_cycle.searches;
        kept.keep_searches_of(settings.n_points);
        for (unsigned int i = 0; i < n; ++i)
          {
            const double at =
              settings.lower + (settings.upper - settings.lower) * i / (n - 1.);
            search(i, at);
          }
      }

    private:
      void
      search(const std::size_t i, const double coordinate)
      {
        const std::string group    = KeptBranches::group_of_search(i);
        const bool        was_done = kept.take_over_search(i);
        const AxisSearch  search =
          was_done ? AxisSearch::from_memory(kept.kept_of(group))
                    : first_search(group, coordinate);
        context.log.info(
          "  search at " + context.parameters.sweep.axes.front().name + " = " +
          rounded_text(search.parameter, 6) + ": " + search.outcome());
        if (!was_done)
          kept.write();
        diagram.searches.push_back(search);
        if (search.starts_branch)
          follow(group);
      }

      /** That a point lies on, from 1 on; 0: none. */
      unsigned int
      branch_of(const BranchPoint &point) const
      {
        const auto found = std::find_if(
          diagram.branches.begin(),
          diagram.branches.end(),
          [&](const CycleBranch &branch) { return lies_on(branch, point); });
        return found == diagram.branches.end()
                 ? 0
                 : found - diagram.branches.begin() + 1;
      }

      AxisSearch
      first_search(const std::string &group, const double coordinate)
      {
        Timers::Section section(context.timers, "Solve: searches along axis");
        AxisSearch      search;
        search.parameter  = grid.value(0, coordinate);
        const auto result = search_at(context, models, coordinate, search);
        if (result)
          {
            settings.multiplier_error = result->multipliers.uncertainty();
            const BranchRun start(
              models.maps(), result->motion, coordinate, settings);
            search.branch        = branch_of(start.start());
            search.starts_branch = search.branch == 0;
            if (search.starts_branch)
              {
                search.branch = diagram.branches.size() + 1;
                keep_start(group, start);
              }
          }
        kept.keep(group, search.memory());
        return search;
      }

      void
      keep_start(const std::string &group, const BranchRun &start)
      {
        kept.keep(group + "/start", start.start_memory());
        NamedNumbers error;
        error.set("multiplier_error", settings.multiplier_error);
        kept.keep(group, error);
      }

      void
      follow(const std::string &group)
      {
        const NamedNumbers start  = kept.kept_of(group);
        settings.multiplier_error = start.number("multiplier_error");
        BranchRun run(models.maps(), start.group("start"), settings);
        diagram.branches.push_back(kept.follow(run, group));
      }

      RunContext         &context;
      const BranchModels &models;
      BranchSettings      settings;
      const SweepGrid     grid;
      KeptBranches       &kept;
      BranchDiagram      &diagram;
    };

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



  BranchDiagram
  branches_of(RunContext         &context,
              const PressedModel &pressed,
              const CycleResult  &start)
  {
    const Parameters  &p        = context.parameters;
    BranchSettings     settings = settings_of(p);
    const BranchModels models(context, pressed);
    if (!models.maps().share_modes())
      settings.smallest_step = smallest_step_with_models;
    require_effect(models.maps(), settings, place_on_axis(p), p);
    KeptBranches  kept(context, pressed);
    BranchDiagram diagram;
    if (start.has_converged())
      {
        settings.multiplier_error = start.multipliers.uncertainty();
        BranchRun run(models.maps(), start.motion, place_on_axis(p), settings);
        diagram.branches.push_back(kept.follow_first(run));
      }
    if (p.limit_cycle.searches > 0)
      AxisRun(context, models, settings, kept, diagram).run();
    const SweepGrid grid(p);
    for (CycleBranch &branch : diagram.branches)
      for (BranchPoint &point : branch.points)
        point.parameter = grid.value(0, point.parameter);
    return diagram;
  }
} // namespace squeal
