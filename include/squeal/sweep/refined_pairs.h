// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_sweep_refined_pairs_h
#define squeal_sweep_refined_pairs_h

#include <squeal/sweep/point_solver.h>

namespace squeal
{
  /** Eigenpairs in a larger basis, from those in its first vectors. */
  struct RefinedPairs
  {
    Eigen::VectorXcd lambda;
    Eigen::MatrixXcd right, left; /**< of mass norm 1; empty unless asked for */
  };

  /**
   * Eigenvalues of the whole of @p matrices that @p pairs, whose vectors are
   * coordinates in the first of its basis vectors, approximate.
   *
   * Two steps of inverse iteration at each eigenvalue. Neighbours with
   * conditions above 30 go together: their two-dimensional invariant subspaces
   * are iterated on at their mean, and the quadratic problem is solved between
   * the left one and the right one. A shift by the Schur complement alone would
   * not do: contact stiffness couples what is left out of the smaller basis to
   * all of it.
   */
  RefinedPairs refine_pairs(const PointMatrices &matrices,
                            const ComplexPairs  &pairs,
                            const bool           with_vectors);
} // namespace squeal

#endif
