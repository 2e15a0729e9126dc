// SPDX-License-Identifier: LGPL-2.1-or-later
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
} // namespace squeal
