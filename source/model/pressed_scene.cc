// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/run_log.h>
#include <squeal/model/pressed_scene.h>

namespace squeal
{
  PressedScene::PressedScene(const Parameters &p, Timers &timers)
    : parameters(p)
    , model(parameters, timers, {}, Model::Contacts::open)
    , pressed(pressed_model(parameters,
                            model,
                            parameters.transient.cut_off,
                            timers,
                            parameters.transient.interface_cut_off))
  {
  }

  std::unique_ptr<const SteadyModel>
  PressedScene::find_steady(const std::vector<ContactParameters> &contacts,
                            RunLog                               &log,
                            Timers                               &timers) const
  {
    try
      {
        return std::make_unique<const SteadyModel>(
          pressed.with_friction(friction_sizes(contacts))
            .steady(parameters.preload.tolerance, timers));
      }
    catch (const ComputationError &e)
      {
        log.warning(e.what());
        return nullptr;
      }
  }
} // namespace squeal
