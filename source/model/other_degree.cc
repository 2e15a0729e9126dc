// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/model/common_parts.h>
#include <squeal/model/other_degree.h>
#include <squeal/model/pressed_conditions.h>
#include <squeal/model/pressed_model.h>

#include <algorithm>

namespace squeal
{
  namespace
  {
    /** Whether all pairs are point springs at places that no mesh moves. */
    bool
    are_all_grids(const SceneParameters &scene)
    {
      return std::all_of(
        scene.contacts.begin(), scene.contacts.end(), [](const auto &contact) {
          return contact.formulation ==
                   ContactParameters::Formulation::springs &&
                 contact.layout == ContactParameters::SpringLayout::grid;
        });
    }

    /** Contact states of @p model for other unknowns: those of point springs
     * stay where they are; mortar nodes are others. */
    std::vector<ContactStates>
    states_for(const Model                     &model,
               const Discretization            &space,
               const std::vector<BodyMatrices> &bodies,
               Timers                          &timers,
               const SharedByScenes            *shared)
    {
      Parameters p = model.parameters();
      if (!has_preload_state(p.scene))
        return {};
      if (!are_all_grids(p.scene))
        {
          if (!shared)
            return preload_states(p, space, bodies, timers);
          p.discretization.degree = space.degree();
          return shared->pressed->states(p, shared->bodies, timers);
        }
      std::vector<ContactStates> result;
      for (const ContactState &state : model.linearized().states)
        result.push_back({state});
      return result;
    }
  } // namespace



  OtherDegree
  with_degree(const Model          &model,
              const unsigned int    degree,
              Timers               &timers,
              const SharedByScenes *shared)
  {
    OtherDegree result;
    result.space      = model.discretization()->with_degree(degree);
    const auto bodies = shared ? shared->parts->bodies(*result.space)
                               : assemble_bodies(*result.space);
    result.system     = linearized_system(
      *result.space,
      bodies,
      states_for(model, *result.space, bodies, timers, shared),
      shared ? &shared->parts->couplings(*result.space) : nullptr);
    result.pencil =
      std::make_unique<Pencil>(result.system.system, model.parameters().scene);
    return result;
  }
} // namespace squeal
