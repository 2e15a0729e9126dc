// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_scene_check_meshes_h
#define squeal_scene_check_meshes_h

#include <squeal/parameters/scene_parameters.h>

namespace squeal
{
  /** Reads the meshes of all bodies, joins them and looks up every face that
   * the scene names, as a run would at its start. Throws InputError. */
  void check_meshes(const SceneParameters &scene);
} // namespace squeal

#endif
