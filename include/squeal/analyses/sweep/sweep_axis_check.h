// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_analyses_sweep_sweep_axis_check_h
#define squeal_analyses_sweep_sweep_axis_check_h

#include <squeal/analyses/sweep/sweep_scenes.h>
#include <squeal/sweep/parametric_system.h>

namespace squeal
{
  /**
   * Looks for axes along which neither mass nor damping nor stiffness of the
   * scene changes, nor the state of a contact: all points along them are the
   * same, and a map over them says that what they name does not matter. Each
   * of several entries of an axis is looked at by itself, too, but where the
   * contact is that of steady sliding, by which alone it may act.
   *
   * @p system has the terms of the scene, not merged. Of a sweep of several
   * scenes it is enough to act in one of @p scenes. Throws InputError naming
   * the first one and what is likely behind it.
   */
  void check_axes_of_sweep(const SweepGrid               &grid,
                           const AffineSystem            &system,
                           const std::vector<SweepScene> &scenes);
} // namespace squeal

#endif
