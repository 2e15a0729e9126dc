// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_cycle_branch_step_h
#define squeal_cycle_branch_step_h

#include <squeal/cycle/cycle_branch.h>

#include <optional>

namespace squeal
{
  /** Of two neighbours on a branch, as BranchSettings measures steps; where in
   * its period a motion starts has no part in it. */
  double branch_distance(const PeriodMaps     &maps,
                         const BranchPoint    &before,
                         const BranchPoint    &last,
                         const BranchSettings &settings);

  /** The angle in the same measure, rad, between the ways from @p before to @p
   * last and from there to @p next. */
  double branch_turn(const PeriodMaps     &maps,
                     const BranchPoint    &before,
                     const BranchPoint    &last,
                     const BranchPoint    &next,
                     const BranchSettings &settings);

  /** The periodic motion a step beyond @p last in the direction from @p before,
   * without its multipliers: Newton's method at right angles to that
   * direction. None where the iterations do not converge. */
  std::optional<BranchPoint> correct_along(const PeriodMaps     &maps,
                                           const BranchPoint    &before,
                                           const BranchPoint    &last,
                                           const double          step,
                                           const BranchSettings &settings);
} // namespace squeal

#endif
