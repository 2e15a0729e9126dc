// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_model_pressed_scene_h
#define squeal_model_pressed_scene_h

#include <squeal/model/pressed_model.h>

namespace squeal
{
  /** What runs of one scene share that differ in friction only: its bodies with
   * open contacts, and their modes up to `Transient/Cut-off`. */
  struct PressedScene
  {
    PressedScene(const Parameters &parameters, Timers &timers);
    PressedScene(const PressedScene &)            = delete;
    PressedScene &operator=(const PressedScene &) = delete;

    const Parameters   parameters;
    const Model        model;
    const PressedModel pressed;
  };
} // namespace squeal

#endif
