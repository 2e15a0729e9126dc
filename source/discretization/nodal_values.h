// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_source_discretization_nodal_values_h
#define squeal_source_discretization_nodal_values_h

#include <squeal/discretization/discretization.h>

namespace squeal
{
  /** The modes (columns) in all unknowns that this rank knows (rows, in the
   * order of Discretization::relevant_dofs()). Collective. */
  Eigen::MatrixXd nodal_values(const Discretization &discretization,
                               const Block          &modes);
} // namespace squeal

#endif
