// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_model_contact_states_h
#define squeal_model_contact_states_h

#include <squeal/contact/contact_geometry.h>
#include <squeal/model/model.h>
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

  /** Of the states of every pair that with @p number, as a list of one; none of
   * pairs without states of their own. */
  std::vector<ContactStates> contact_of_number(
    const std::vector<ContactStates> &of_pairs,
    const unsigned int                number);

  /** Steady sliding of a scene whose numbers are changed. */
  class ChangedContact
  {
  public:
    /** References are kept. */
    ChangedContact(const Parameters &parameters, Timers &timers);

    /** Whether steady sliding of @p scene, which differs from that of the
     * parameters in numbers, has the contact @p held, one state a pair, none
     * of pairs whose state is not `preload`: the same status of all points
     * and, where forces enter the matrices, the same forces. False where there
     * is no steady sliding. Collective. */
    bool is_that(const SceneParameters            &scene,
                 const std::vector<ContactStates> &held) const;

  private:
    const Parameters &parameters;
    Timers           &timers;
    const Model       model; /**< its contacts are open */
  };
} // namespace squeal

#endif
