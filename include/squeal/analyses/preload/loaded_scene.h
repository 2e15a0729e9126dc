// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_analyses_preload_loaded_scene_h
#define squeal_analyses_preload_loaded_scene_h

#include <squeal/parameters/parameters.h>

namespace squeal
{
  /** The scene of the loads: without damping, with contacts whose status
   * follows, and with held supports guided, as such a support is kept where the
   * loads have moved it. */
  Parameters loaded_scene(const Parameters &parameters);
} // namespace squeal

#endif
