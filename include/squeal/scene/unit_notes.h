// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_scene_unit_notes_h
#define squeal_scene_unit_notes_h

#include <squeal/parameters/parameters.h>

#include <string>
#include <vector>

namespace squeal
{
  /** The Young modulus of an isotropic body, else the lowest along its axes,
   * Pa. */
  double lowest_young_modulus(const BodyParameters &body);

  /**
   * Sizes, moduli and densities of a scene of bodies that no brake has and a
   * wrong unit gives, a sentence each: a scene of more than 10 m or less than
   * 1 mm, a Young modulus below 2.5e5 Pa (steel in MPa is 2.1e5), at which the
   * cores of shims still are stiffer, and a density below 25 kg/m^3 (all that
   * is given in g/cm^3) or above 1e6. Densities of bodies that stand for more
   * mass than they have room for are within. Meshes that cannot be read say
   * nothing here, and imported matrices have no sizes.
   */
  std::vector<std::string> notes_on_units(const SceneParameters &scene);

  /** Young moduli below that limit that the axes of a sweep give, likewise. */
  std::vector<std::string> notes_on_units(const SweepParameters &sweep);

  /** Adds both to the notes, which runs and validations say. */
  void note_units(Parameters &parameters);
} // namespace squeal

#endif
