// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_model_turning_modes_h
#define squeal_model_turning_modes_h

#include <squeal/eigen/free_motion.h>
#include <squeal/model/mode_solution.h>

#include <string>

namespace squeal
{
  /** Whether a body turns through the fixed frame. */
  bool has_turning_body(const SceneParameters &scene);

  /**
   * Up to which omega^2 the modes of K - Omega^2 N, the stiffness of turning
   * bodies in the fixed frame, must be known if none of the motions up to
   * @p highest (rad/s) is to be missed.
   *
   * Waves that run against the turning are carried forwards by c = m Omega:
   * their frequency falls from sqrt(omega^2 + c^2) at rest by c. So it is below
   * the highest one where omega^2 is below highest^2 + 2 c highest. c is the
   * largest of the gyroscopic forces between @p modes; where the limit goes up,
   * so may c.
   */
  double limit_of_turning_modes(const Model         &model,
                                const UndampedModes &modes,
                                const double         highest);

  /** Motions of the bodies at rest that nothing holds, see
   * find_free_motions() of @p limit, (rad/s)^2. */
  FreeMotions free_motions_at_rest(const Model &model, const double limit);

  /** "the bodies turn faster than ..." with the critical speed, where the
   * stiffness in the fixed frame vanishes; empty below it. */
  std::string beyond_critical_speed(const Model        &model,
                                    const ModeSolution &solution);
} // namespace squeal

#endif
