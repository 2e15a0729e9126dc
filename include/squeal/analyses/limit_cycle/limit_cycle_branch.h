// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_analyses_limit_cycle_limit_cycle_branch_h
#define squeal_analyses_limit_cycle_limit_cycle_branch_h

#include <squeal/cycle/cycle_branch.h>
#include <squeal/model/period_map_of.h>

#include <optional>

namespace squeal
{
  class RunContext;

  /** Throws InputError where the scene is not on the axis of the sweep. */
  void require_on_axis(const Parameters &parameters);

  /** The modes that an earlier run has saved its branch in; empty where there
   * is none. Collective. */
  std::optional<SavedModes> modes_of_branch(RunContext &context);

  /** The branch of @p start over the values of the sweep's axis, from where an earlier
   * run has left it in the branch file on, which has every point as soon as it
   * is found. A signal ends the program after the point at hand. */
  CycleBranch branch_of(RunContext         &context,
                        const PressedModel &pressed,
                        const CycleResult  &start);
} // namespace squeal

#endif
