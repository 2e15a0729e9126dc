// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_discretization_load_vector_h
#define squeal_discretization_load_vector_h

#include <squeal/base/row_space.h>
#include <squeal/discretization/discretization.h>
#include <squeal/discretization/point_evaluator.h>

namespace squeal
{
  /**
   * Nodal forces of a load, N, one column in the rows of the discretisation:
   * its resultant spread evenly over the face and its pressure against the
   * outward normals, or force and moment on a rigid body. Throws InputError
   * where body or face do not exist.
   */
  Block load_vector(const Discretization &discretization,
                    const PointEvaluator &evaluator,
                    const LoadParameters &load);
} // namespace squeal

#endif
