// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_discretization_even_faces_h
#define squeal_discretization_even_faces_h

#include <squeal/discretization/discretization.h>

#include <vector>

namespace squeal
{
  /** Ids of the faces on which hanging nodes are not allowed, what
   * Discretization::refine() takes as whole: the source faces of mortar
   * contacts, those of nodes on a surface, and of ties that are not
   * conforming. */
  std::vector<unsigned int> even_faces(const Discretization &discretization);
} // namespace squeal

#endif
