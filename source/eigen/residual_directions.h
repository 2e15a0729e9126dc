// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_eigen_residual_directions_h
#define squeal_eigen_residual_directions_h

#include <squeal/discretization/affine_system.h>

namespace squeal
{
  /** Directions of the columns z_j / scale_j with scale_j > 0, real and
   * imaginary parts, with singular values above @p limit and above 1e-4 of
   * the largest: one enrichment does not contract by more. Frees @p Z. */
  Block compress(const RowSpace        &space,
                 ComplexBlock          &Z,
                 const Eigen::VectorXd &scales,
                 const double           limit);
} // namespace squeal

#endif
