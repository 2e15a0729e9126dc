// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/analyses/limit_cycle/branch_models.h>

#include <squeal/model/period_map_of.h>
#include <squeal/parameters/entry_traits.h>
#include <squeal/run/run_context.h>
#include <squeal/sweep/sweep_grid.h>

#include <algorithm>
#include <deque>

namespace squeal
{
  namespace
  {
    /** Two neighbours, the point that is sought and one beside it. */
    constexpr std::size_t n_kept = 4;
  } // namespace



  BranchModel::BranchModel(const double at, const SteadyModel &a)
    : coordinate(at)
    , about(a)
    , map(period_map_of(about))
  {
  }

  BranchModel::BranchModel(const double                        at,
                           std::shared_ptr<const PressedScene> made,
                           const double                        tolerance,
                           Timers                             &timers)
    : coordinate(at)
    , scene(std::move(made))
    , about(scene->pressed.steady(tolerance, timers))
    , map(period_map_of(about))
  {
  }



  class BranchModels::Kept
  {
  public:
    Kept(RunContext &c, const PressedModel &p)
      : context(c)
      , pressed(p)
      , grid(c.parameters)
      , is_friction(std::all_of(c.parameters.sweep.axes.front().entries.begin(),
                                c.parameters.sweep.axes.front().entries.end(),
                                &is_friction_entry))
    {
    }

    bool
    share_modes() const
    {
      return is_friction;
    }

    std::shared_ptr<const BranchModel>
    at(const double coordinate)
    {
      const auto found =
        std::find_if(latest.begin(), latest.end(), [&](const auto &m) {
          return m->coordinate == coordinate;
        });
      std::shared_ptr<const BranchModel> model;
      if (found != latest.end())
        {
          model = *found;
          latest.erase(found);
        }
      else
        {
          if (latest.size() == n_kept)
            latest.pop_back();
          model = made(coordinate);
        }
      latest.push_front(model);
      return model;
    }

    ModeChange
    change(const double from, const double to)
    {
      const auto a = at(from), b = at(to);
      return {b->about.pressed.coordinates_of(a->about.pressed),
              a->about.sliding.coordinates,
              b->about.sliding.coordinates};
    }

  private:
    std::shared_ptr<const BranchModel>
    made(const double coordinate) const
    {
      const SceneParameters &there =
        grid.scene(SweepPoint::Constant(1, coordinate));
      const double tolerance = context.parameters.preload.tolerance;
      if (is_friction)
        return std::make_shared<const BranchModel>(
          coordinate,
          pressed.with_friction(friction_sizes(there.contacts))
            .steady(tolerance, context.timers));
      Parameters p = context.parameters;
      p.scene      = there;
      for (auto &contact : p.scene.contacts)
        contact.state = ContactParameters::State::full;
      return std::make_shared<const BranchModel>(
        coordinate,
        std::make_shared<const PressedScene>(p, context.timers),
        tolerance,
        context.timers);
    }

    RunContext                                    &context;
    const PressedModel                            &pressed;
    const SweepGrid                                grid;
    const bool                                     is_friction;
    std::deque<std::shared_ptr<const BranchModel>> latest; /**< it first */
  };



  BranchModels::BranchModels(RunContext &context, const PressedModel &pressed)
    : kept(std::make_shared<Kept>(context, pressed))
  {
  }

  BranchModels::~BranchModels() = default;

  std::shared_ptr<const BranchModel>
  BranchModels::at(const double coordinate) const
  {
    return kept->at(coordinate);
  }

  PeriodMaps
  BranchModels::maps() const
  {
    PeriodMaps maps;
    maps.at = [models = kept](const double coordinate) {
      const auto model = models->at(coordinate);
      return PeriodMaps::Map(model, &model->map);
    };
    if (!kept->share_modes())
      maps.change = [models = kept](const double from, const double to) {
        return models->change(from, to);
      };
    return maps;
  }
} // namespace squeal
