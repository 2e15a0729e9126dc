// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_analyses_angles_turned_rotor_h
#define squeal_analyses_angles_turned_rotor_h

#include <squeal/parameters/parameters.h>

namespace squeal
{
  /**
   * The scene with the `Turning bodies` turned by @p angle, degrees, from where
   * they stand: each body keeps its own angle to the others, and with them turn
   * the axes of orthotropic materials and the springs between two of them.
   * Springs along x, y and z are then springs of their own along the turned
   * directions. All else stays in space.
   */
  Parameters turned_rotor(const Parameters &p, const double angle);
} // namespace squeal

#endif
