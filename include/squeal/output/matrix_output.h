// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_output_matrix_output_h
#define squeal_output_matrix_output_h

#include <squeal/eigen/complex_pairs.h>
#include <squeal/model/mode_solution.h>
#include <squeal/run/run_context.h>

#include <string>

namespace squeal
{
  /**
   * Writes M, C and K of (lambda^2 M + lambda C + K) x = 0, friction in K, to
   * mass.mtx, damping.mtx and stiffness.mtx in @p folder of the output
   * directory. Collective; throws InputError as write_matrix_market().
   */
  void write_matrices(RunContext        &context,
                      const Pencil      &pencil,
                      const std::string &folder);

  /**
   * Writes the operators of which M, C and K are sums, one file each
   * (part_01_mass_of_disc.mtx), index.json with their names and coefficients
   * and, where K is real and M symmetric, scene.prm: the scene of kind
   * `matrices` that is the same problem again.
   */
  void write_matrix_parts(RunContext         &context,
                          const AffineSystem &system,
                          const std::string  &folder);

  /** Writes eigenvalues (column) and right vectors (their columns) to
   * eigenvalues.mtx and right_vectors.mtx. */
  void write_eigenpairs(RunContext         &context,
                        const RowSpace     &space,
                        const ComplexPairs &pairs,
                        const std::string  &folder);
} // namespace squeal

#endif
