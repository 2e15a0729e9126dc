// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/model/pressed_conditions.h>
#include <squeal/model/pressed_model.h>

namespace squeal
{
  /** The scene of a condition cut open and pressed on. */
  struct PressedConditions::Condition
  {
    Condition(const Parameters &p, Timers &timers)
      : parameters(without_damping(p))
      , open(parameters,
             timers,
             std::vector<ContactStates>(),
             Model::Contacts::open)
      , pressed(pressed_for_many_states(parameters, open, timers))
    {
    }

    const Parameters   parameters;
    const Model        open;
    const PressedModel pressed;
  };



  PressedConditions::PressedConditions()  = default;
  PressedConditions::~PressedConditions() = default;

  std::vector<ContactStates>
  PressedConditions::states(const Parameters &here,
                            const std::size_t bodies,
                            Timers           &timers)
  {
    if (!has_preload_state(here.scene))
      return {};
    const Parameters undamped = without_damping(here);
    if (first)
      if (const auto other = first->pressed.with_moduli(undamped))
        return preload_states(*other, undamped, timers);
    if (first && bodies == bodies_of_first)
      return preload_states(
        first->pressed.with_sliding(undamped, timers), undamped, timers);
    first           = std::make_unique<const Condition>(here, timers);
    bodies_of_first = bodies;
    return preload_states(first->pressed, undamped, timers);
  }
} // namespace squeal
