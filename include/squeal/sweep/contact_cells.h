// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_sweep_contact_cells_h
#define squeal_sweep_contact_cells_h

#include <squeal/sweep/sweep_grid.h>

namespace squeal
{
  /** Whether all points of the grid at the corners of the cell that holds
   * @p point have one contact state. A point on the grid is a corner of its
   * own; beyond an end of an axis the end is the corner. Where they differ the
   * contact state of the point is not known: that of the nearest one is held.
   */
  bool has_known_contact(const SweepGrid &grid, const SweepPoint &point);

  /** How far the root of something at @p point may be off along the first axis,
   * in its coordinate, since the contact state is held there: the distance to
   * the farther one of the two neighbouring points of the grid, half a step
   * where the state changes; 0 where the contact is known. */
  double error_by_held_contact(const SweepGrid &grid, const SweepPoint &point);
} // namespace squeal

#endif
