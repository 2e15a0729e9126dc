// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_run_entry_units_h
#define squeal_run_entry_units_h

#include <squeal/parameters/scene_parameters.h>

#include <string>

namespace squeal
{
  /** The declared unit of the entry that a number of a sweep or a campaign is
   * in, "Pa" of "Scene/Body pad/Young modulus"; empty where it has none.
   * Springs of @p scene tell whether theirs is that of points or of a bed. */
  std::string unit_of_entry(const std::string     &path,
                            const SceneParameters &scene);
} // namespace squeal

#endif
