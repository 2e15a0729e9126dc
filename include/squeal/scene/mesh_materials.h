// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_scene_mesh_materials_h
#define squeal_scene_mesh_materials_h

#include <squeal/parameters/parameters.h>
#include <squeal/scene/mesh_file.h>

namespace squeal
{
  /** Gives the bodies that ask for it the material of their mesh files, in SI
   * units. Throws InputError where a file gives a body none, several, or one
   * that is not isotropic and constant or not within the usual bounds. */
  void take_mesh_materials(SceneParameters &scene);

  /** The same before Parameters::check(). The entries as used then hold the
   * numbers of the files and say "Material from mesh file = false": whatever
   * is read from them again (scenes of a sweep, the run repeated by its
   * parameters_used.prm) has these materials. Throws InputError as above, and
   * for what is wrong with such a body itself. */
  void take_mesh_materials(Parameters &parameters);

  /** A sentence for the log where the file gives the cells of a body another
   * material than it has; empty where they agree to 1e-6 or the file says
   * nothing. */
  std::string material_remark(const BodyParameters &body, const MeshFile &file);
} // namespace squeal

#endif
