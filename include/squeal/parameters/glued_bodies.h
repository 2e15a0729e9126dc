// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_parameters_glued_bodies_h
#define squeal_parameters_glued_bodies_h

#include <squeal/parameters/scene_parameters.h>

#include <array>
#include <set>
#include <string>
#include <vector>

namespace squeal
{
  /** Bodies that are glued: those of ties, and layers with the bodies that they
   * lie on. */
  std::vector<std::array<std::string, 2>> glued_bodies(
    const SceneParameters &scene);

  /** The body called @p body and all that is glued to it, through others too.
   */
  std::set<std::string> glued_to(const SceneParameters &scene,
                                 const std::string     &body);
} // namespace squeal

#endif
