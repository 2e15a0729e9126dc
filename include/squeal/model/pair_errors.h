// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_model_pair_errors_h
#define squeal_model_pair_errors_h

#include <squeal/discretization/pair_error.h>
#include <squeal/model/mode_solution.h>

#include <squeal/eigen/complex_pairs.h>

namespace squeal
{
  /** Estimated errors of complex pairs by the mesh, with the forces of springs,
   * contacts and ties. All are NaN where a body turns through the fixed frame
   * or the scene is not meshed. */
  PairErrors pair_mesh_errors(const Model        &model,
                              const Pencil       &pencil,
                              const ComplexPairs &pairs);
} // namespace squeal

#endif
