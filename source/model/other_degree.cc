// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/model/other_degree.h>
#include <squeal/model/pressed_model.h>

namespace squeal
{
  namespace
  {
    /** Contact states of @p model for other unknowns: those of point springs
     * stay where they are; mortar nodes are others. */
    std::vector<ContactStates>
    states_for(const Model                     &model,
               const Discretization            &space,
               const std::vector<BodyMatrices> &bodies,
               Timers                          &timers)
    {
      bool has_preload = false, all_grids = true;
      for (const auto &contact : model.parameters().scene.contacts)
        {
          has_preload =
            has_preload || contact.state == ContactParameters::State::preload;
          all_grids =
            all_grids &&
            contact.formulation == ContactParameters::Formulation::springs &&
            contact.layout == ContactParameters::SpringLayout::grid;
        }
      if (!has_preload)
        return {};
      if (!all_grids)
        return preload_states(model.parameters(), space, bodies, timers);
      std::vector<ContactStates> result;
      for (const ContactState &state : model.linearized().states)
        result.push_back({state});
      return result;
    }
  } // namespace



  OtherDegree
  with_degree(const Model &model, const unsigned int degree, Timers &timers)
  {
    OtherDegree result;
    result.space      = model.discretization()->with_degree(degree);
    const auto bodies = assemble_bodies(*result.space);
    result.system     = linearized_system(
      *result.space, bodies, states_for(model, *result.space, bodies, timers));
    result.pencil =
      std::make_unique<Pencil>(result.system.system, model.parameters().scene);
    return result;
  }
} // namespace squeal
