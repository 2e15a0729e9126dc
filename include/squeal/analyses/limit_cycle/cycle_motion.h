// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_analyses_limit_cycle_cycle_motion_h
#define squeal_analyses_limit_cycle_cycle_motion_h

#include <squeal/cycle/orbit.h>
#include <squeal/model/pressed_model.h>

namespace squeal
{
  /** Motions of the bodies under the full load, m: free unknowns of the
   * discretisation, a column for each of @p n_frames moments of the period of
   * @p orbit, evenly spaced to half a step; the first at its start. Collective;
   * factorises once. */
  Block motion_of_cycle(const SteadyModel &about,
                        const Orbit       &orbit,
                        const unsigned int n_frames);
} // namespace squeal

#endif
