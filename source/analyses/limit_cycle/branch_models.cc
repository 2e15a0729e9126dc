// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/analyses/limit_cycle/branch_models.h>

#include <squeal/model/period_map_of.h>
#include <squeal/model/pressed_scene.h>
#include <squeal/parameters/entry_traits.h>
#include <squeal/run/run_context.h>
#include <squeal/sweep/sweep_grid.h>

#include <algorithm>
#include <deque>

namespace squeal
{
  namespace
  {
    /** Steady sliding at one value of the parameter and the motions about it.
     */
    struct BranchModel
    {
      BranchModel(const double at, const SteadyModel &a)
        : parameter(at)
        , about(a)
        , map(period_map_of(about))
      {
      }
      BranchModel(const double                        at,
                  std::shared_ptr<const PressedScene> made,
                  const double                        tolerance,
                  Timers                             &timers)
        : parameter(at)
        , scene(std::move(made))
        , about(scene->pressed.steady(tolerance, timers))
        , map(period_map_of(about))
      {
      }
      const double                              parameter;
      const std::shared_ptr<const PressedScene> scene; /**< or null */
      const SteadyModel                         about;
      const PeriodMap                           map;
    };

    /** Two neighbours, the point that is sought and one beside it. */
    constexpr std::size_t n_kept = 4;

    /** The last ones that were asked for are kept. */
    class BranchModels
    {
    public:
      BranchModels(RunContext &c, const PressedModel &p)
        : context(c)
        , pressed(p)
        , grid(c.parameters)
        , is_friction(
            std::all_of(c.parameters.sweep.axes.front().entries.begin(),
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
      at(const double parameter)
      {
        const auto found =
          std::find_if(kept.begin(), kept.end(), [&](const auto &m) {
            return m->parameter == parameter;
          });
        std::shared_ptr<const BranchModel> model;
        if (found != kept.end())
          {
            model = *found;
            kept.erase(found);
          }
        else
          {
            if (kept.size() == n_kept)
              kept.pop_back();
            model = made(parameter);
          }
        kept.push_front(model);
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
      made(const double parameter) const
      {
        const SceneParameters &there =
          grid.scene(SweepPoint::Constant(1, parameter));
        const double tolerance = context.parameters.preload.tolerance;
        if (is_friction)
          return std::make_shared<const BranchModel>(
            parameter,
            pressed.with_friction(friction_sizes(there.contacts))
              .steady(tolerance, context.timers));
        Parameters p = context.parameters;
        p.scene      = there;
        for (auto &contact : p.scene.contacts)
          contact.state = ContactParameters::State::full;
        return std::make_shared<const BranchModel>(
          parameter,
          std::make_shared<const PressedScene>(p, context.timers),
          tolerance,
          context.timers);
      }

      RunContext                                    &context;
      const PressedModel                            &pressed;
      const SweepGrid                                grid;
      const bool                                     is_friction;
      std::deque<std::shared_ptr<const BranchModel>> kept; /**< latest first */
    };
  } // namespace



  PeriodMaps
  branch_maps(RunContext &context, const PressedModel &pressed)
  {
    const auto models = std::make_shared<BranchModels>(context, pressed);
    PeriodMaps maps;
    maps.at = [models](const double parameter) {
      const auto model = models->at(parameter);
      return PeriodMaps::Map(model, &model->map);
    };
    if (!models->share_modes())
      maps.change = [models](const double from, const double to) {
        return models->change(from, to);
      };
    return maps;
  }
} // namespace squeal
