// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_eigen_same_operators_h
#define squeal_eigen_same_operators_h

#include <squeal/discretization/affine_system.h>

namespace squeal
{
  /** Whether mass, damping and stiffness of two pencils do the same to a random
   * vector, but for the rounding of each row: whatever they are made from.
   * Collective. */
  bool same_operators(const Pencil &a, const Pencil &b);

  /** The same of their symmetric parts alone: the frictionless problem, whose
   * factor and modes serve both then. Collective. */
  bool same_symmetric_operators(const Pencil &a, const Pencil &b);
} // namespace squeal

#endif
