// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_model_linear_solver_h
#define squeal_model_linear_solver_h

#include <squeal/eigen/mass_basis.h>
#include <squeal/eigen/undamped_modes.h>
#include <squeal/parameters/parameters.h>

#include <string>

namespace squeal
{
  /** Where the factor of a matrix in the rows of @p space may be, as
   * Eigenvalues/Linear solver has it; with files in the output directory. */
  FactorStorage factor_storage(const Parameters &parameters,
                               const RowSpace   &space);

  /** Whether a reduced basis that starts with @p n_start vectors keeps its
   * products with the matrices: by Eigenvalues/Linear solver, `automatic` by
   * the memory that is free now. */
  BasisProducts basis_products(const Parameters  &parameters,
                               const RowSpace    &space,
                               const Eigen::Index n_start);

  /** What was chosen, in words: "factors in memory, 1.2 GB". */
  std::string linear_solver_text(const ShiftedInverse &inverse);
} // namespace squeal

#endif
