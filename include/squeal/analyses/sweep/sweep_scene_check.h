// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_analyses_sweep_sweep_scene_check_h
#define squeal_analyses_sweep_sweep_scene_check_h

#include <squeal/model/model.h>
#include <squeal/sweep/parametric_system.h>

#include <vector>

namespace squeal
{
  class Timers;

  /**
   * Assembles the scene anew at an end of all axes and compares mass, damping
   * and stiffness with those that the sweep makes of the operators of the
   * scene in the file, by products with random vectors.
   *
   * @param states of every pair, if they change over the grid
   * Throws InputError, naming the point, where they differ.
   */
  void check_scene_of_sweep(const Parameters                 &parameters,
                            const SweepGrid                  &grid,
                            const ParametricSystem           &system,
                            const std::vector<ContactStates> &states,
                            Timers                           &timers);
} // namespace squeal

#endif
