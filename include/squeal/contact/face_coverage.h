// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_contact_face_coverage_h
#define squeal_contact_face_coverage_h

#include <squeal/discretization/discretization.h>

namespace squeal
{
  /**
   * Contact springs at the quadrature points of a face and elastic beds between
   * two bodies carry the area round every point: all of each cell's face must
   * have its target opposite, not the points alone. A bed may also lie inside
   * its other body. Meshes of one surface may differ by #limits_of_meshes.
   * Throws InputError that names the pair or bed, the place and the share.
   */
  void check_faces_covered(const Discretization &discretization);
} // namespace squeal

#endif
