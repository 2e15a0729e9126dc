// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_parameters_entry_traits_h
#define squeal_parameters_entry_traits_h

#include <squeal/parameters/scene_parameters.h>

#include <string>
#include <vector>

namespace squeal
{
  /**
   * What the declaration of an entry says of it, for numbers that sweeps,
   * campaigns and fits change. One of several numbers, "Young moduli[2]", has
   * the traits of all; an unknown path has none.
   */
  //@{
  /** The unit, "Pa" of "Scene/Body pad/Young modulus"; empty where it has none.
   * Springs of @p scene tell whether theirs is that of points or of a bed. */
  std::string unit_of_entry(const std::string     &path,
                            const SceneParameters &scene);

  /**
   * What charts call the numbers that change together, @p paths: "E_pad", "mu",
   * "pad position [1]"; "mu of all contacts" and "E_pad and 4 others" for
   * several. A coefficient of friction tells its contact only where @p scene has
   * several.
   */
  std::string symbol_of_entries(const std::vector<std::string> &paths,
                                const SceneParameters          &scene);

  /** The same with the unit, "E_pad in Pa". */
  std::string axis_title(const std::vector<std::string> &paths,
                         const SceneParameters          &scene);

  /** Whether the entry enters only by coefficients of affine parts. */
  bool is_affine_entry(const std::string &path);

  /** Whether the entry is a coefficient of friction. */
  bool is_friction_entry(const std::string &path);

  /** Whether the entry says how finely a run computes. */
  bool is_resolution_entry(const std::string &path);
  //@}
} // namespace squeal

#endif
