// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/timers.h>
#include <squeal/model/pressed_model.h>

namespace squeal
{
  namespace
  {
    OpenScene
    open_imported(const SceneParameters &scene,
                  const ImportedModel   &model,
                  Timers                &timers)
    {
      Timers::Section section(timers, "Assemble: open contact");
      return open_scene(scene, model);
    }

    PressedModel
    pressed_model_of(const Parameters &parameters,
                     const Model      &model,
                     const double      cut_off,
                     Timers           &timers,
                     const double      interface_cut_off,
                     const Flexibility flexibility,
                     const SavedModes *earlier = nullptr)
    {
      if (model.imported() == nullptr)
        return {parameters,
                *model.discretization(),
                model.body_matrices(),
                cut_off,
                timers,
                interface_cut_off,
                flexibility,
                earlier};
      return {parameters,
              open_imported(parameters.scene, *model.imported(), timers),
              cut_off,
              timers,
              interface_cut_off,
              flexibility,
              earlier};
    }
  } // namespace

  PressedModel
  pressed_model(const Parameters &parameters,
                const Model      &model,
                const double      cut_off,
                Timers           &timers,
                const double      interface_cut_off,
                const SavedModes *earlier)
  {
    return pressed_model_of(parameters,
                            model,
                            cut_off,
                            timers,
                            interface_cut_off,
                            Flexibility::complete,
                            earlier);
  }

  PressedModel
  pressed_for_states(const Parameters &parameters,
                     const Model      &model,
                     Timers           &timers)
  {
    return pressed_model_of(parameters,
                            model,
                            cut_off_of_statics(parameters),
                            timers,
                            0.,
                            Flexibility::of_sliding);
  }


  PressedModel
  pressed_for_many_states(const Parameters &parameters,
                          const Model      &model,
                          Timers           &timers)
  {
    // The state of a held support is that of another scene.
    return pressed_model_of(parameters,
                            model,
                            cut_off_of_statics(parameters),
                            timers,
                            0.,
                            has_held_support(parameters.scene)
                              ? Flexibility::of_sliding
                              : Flexibility::of_sliding_by_part);
  }


  std::vector<ContactStates>
  preload_states(const PressedModel &pressed,
                 const Parameters   &parameters,
                 Timers             &timers)
  {
    auto states = pressed.states_of(
      pressed.steady(parameters.preload.tolerance, timers).sliding);
    for (std::size_t i = 0; i < states.size(); ++i)
      if (parameters.scene.contacts[i].state !=
          ContactParameters::State::preload)
        states[i].clear();
    return states;
  }

  std::vector<ContactStates>
  preload_states(const Parameters                &parameters,
                 const Discretization            &discretization,
                 const std::vector<BodyMatrices> &bodies,
                 Timers                          &timers)
  {
    const Parameters p = without_damping(parameters);
    return preload_states(PressedModel(p,
                                       discretization,
                                       bodies,
                                       cut_off_of_statics(p),
                                       timers,
                                       0.,
                                       Flexibility::of_sliding),
                          parameters,
                          timers);
  }

  std::vector<ContactStates>
  preload_states(const Parameters    &parameters,
                 const ImportedModel &model,
                 Timers              &timers)
  {
    const Parameters p = without_damping(parameters);
    return preload_states(PressedModel(p,
                                       open_imported(p.scene, model, timers),
                                       cut_off_of_statics(p),
                                       timers,
                                       0.,
                                       Flexibility::of_sliding),
                          parameters,
                          timers);
  }
} // namespace squeal
