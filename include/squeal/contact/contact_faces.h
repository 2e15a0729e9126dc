// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_contact_contact_faces_h
#define squeal_contact_contact_faces_h

#include <squeal/discretization/discretization.h>

namespace squeal
{
  /**
   * Signs of gap, pressure and friction are those of a target that lies under
   * its source: the outward normal of the target face is +z, that of the source
   * face -z. Looks at the normals of the mesh faces of every contact pair, so
   * that curved, tilted and turned faces of mesh files are found too; of the
   * target face those parts count that lie under the source face.
   *
   * Throws InputError that names contact, face and normal where one is off by
   * more than 1e-3 (which would shift the coefficient of friction by as much),
   * where the bodies have no faces of these names, and where the named target
   * face is not where the source face is. Pairs of rigid bodies have no faces:
   * their normal is +z by definition.
   */
  void check_contact_faces(const Discretization &discretization);
} // namespace squeal

#endif
