// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_contact_contact_faces_h
#define squeal_contact_contact_faces_h

#include <squeal/contact/contact_geometry.h>

namespace squeal
{
  /**
   * Looks at the mesh faces of every contact pair of meshed bodies before
   * anything is assembled: at all Gauss points of the source face there must be
   * the named target face, its normal against that of the source, and a sliding
   * direction along it, with the turning of the bodies and not against it; and
   * springs need their targets, as check_faces_covered() has it.
   * Throws InputError that names contact and place, as contact_frames() and
   * require_sliding_as_turning(), and where the source body has no faces of
   * that name.
   */
  void check_contact_faces(const Discretization &discretization);
} // namespace squeal

#endif
