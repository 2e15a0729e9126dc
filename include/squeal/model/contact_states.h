// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_model_contact_states_h
#define squeal_model_contact_states_h

#include <squeal/contact/contact_geometry.h>
#include <squeal/run/run_context.h>
#include <squeal/sweep/sweep_grid.h>

#include <vector>

namespace squeal
{
  /**
   * The contact states of steady sliding at all points of @p grid, those alike
   * once, as a list for each pair; enters in @p grid which one holds where.
   * Shares of the normal force are those of the point in the middle of its
   * state. Empty where no contact has the state `preload`. Throws
   * ComputationError, naming the point, where there is no steady sliding.
   */
  std::vector<ContactStates> contact_states_of(const Parameters &parameters,
                                               SweepGrid        &grid,
                                               RunContext       &context);
} // namespace squeal

#endif
