// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_model_pressed_scene_h
#define squeal_model_pressed_scene_h

#include <squeal/model/pressed_model.h>

#include <memory>
#include <vector>

namespace squeal
{
  class RunLog;

  /** What runs of one scene share that differ in friction only: its bodies with
   * open contacts, and their modes up to `Transient/Cut-off`. */
  struct PressedScene
  {
    PressedScene(const Parameters &parameters, Timers &timers);
    PressedScene(const PressedScene &)            = delete;
    PressedScene &operator=(const PressedScene &) = delete;

    /** Steady sliding with the coefficients of friction of @p contacts; null
     * where there is none, with a warning. */
    std::unique_ptr<const SteadyModel> find_steady(
      const std::vector<ContactParameters> &contacts,
      RunLog                               &log,
      Timers                               &timers) const;

    const Parameters   parameters;
    const Model        model;
    const PressedModel pressed;
  };
} // namespace squeal

#endif
