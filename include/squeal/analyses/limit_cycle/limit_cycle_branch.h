// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_analyses_limit_cycle_limit_cycle_branch_h
#define squeal_analyses_limit_cycle_limit_cycle_branch_h

#include <squeal/analyses/limit_cycle/axis_search.h>

namespace squeal
{
  class RunContext;

  /** Throws InputError where the scene is not on the axis of the sweep. */
  void require_on_axis(const Parameters &parameters);

  /** The branch of @p start over the values of the sweep's axis, and those that
   * begin where `Searches along axis` find cycles beyond it, from where an
   * earlier run has left them in the branch file on, which has every point as
   * soon as it is found. Without a cycle at @p start the searches alone. A
   * signal ends the program after the point or the search at hand. */
  BranchDiagram branches_of(RunContext         &context,
                            const PressedModel &pressed,
                            const CycleResult  &start);
} // namespace squeal

#endif
