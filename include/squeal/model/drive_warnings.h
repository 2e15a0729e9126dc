// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_model_drive_warnings_h
#define squeal_model_drive_warnings_h

#include <squeal/parameters/parameters.h>
#include <squeal/transient/steady_sliding.h>

namespace squeal
{
  class PressedModel;
  class RunLog;

  /** Warns of what the entries of a motion in time say about its drive and the
   * run does not do, or cannot tell apart: ramps of loads that are there from
   * the start, and a trigger while a load still comes on. */
  void warn_of_drive(const Parameters &parameters, RunLog &log);

  /** Warns of each pair of @p scene that slides at a point of its table of
   * friction, see remark_on_kink(); of the same one once. */
  void warn_of_kinks(const SceneParameters &scene, RunLog &log);

  /** Warns where friction falls with the slip rate and the steps of the reduced
   * integrator are so short that its lag holds no node, see lag_limit(). @p
   * steady is that of @p pressed. */
  void warn_of_short_lag(const PressedModel  &pressed,
                         const SteadySliding &steady,
                         const Parameters    &parameters,
                         RunLog              &log);
} // namespace squeal

#endif
