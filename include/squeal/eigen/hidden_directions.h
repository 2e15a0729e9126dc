// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_eigen_hidden_directions_h
#define squeal_eigen_hidden_directions_h

#include <squeal/eigen/reduced_basis.h>
#include <squeal/eigen/sliding_inverse.h>

namespace squeal
{
  /**
   * Looks for pairs near the band that motions carry of which the start V of a
   * basis holds nothing.
   *
   * Where a part of the scene is exactly decoupled from the rest and its
   * undamped modes all lie above the start, no residual of another pair ever
   * leads to it; but friction, gyroscopic terms or dashpots can bring its pairs
   * into the band. With all that the undamped modes do not have, friction F and
   * damping C, such a pair obeys x = -S (F + lambda C) x with S the inverse of
   * the undamped problem, for which the factor at the edge of the band serves
   * as long as the modes of the part are far above. With S' that of the problem
   * with friction, S' (F + |lambda| C) amplifies what is near that. A block
   * Krylov sequence of it, mass-orthogonal to V, from random columns, which
   * have a share in every part, is a space in which the whole problem is
   * solved; what is near the band there is improved by the responses to its
   * residuals.
   */
  struct HiddenSearch
  {
    const Pencil         &pencil;
    const SlidingInverse &inverse; /**< at the edge of the band */
    const double          edge;    /**< rad/s; 0: nothing is sought */
    const Pencil         &metric;  /**< whose mass V is orthonormal in */

    /** Columns that span the right and left vectors found; none where nothing
     * is hidden. @p V is N x n; @p seed tells the random columns of one search
     * from those of another. */
    Block directions(const Eigen::Ref<const Block> &V,
                     const unsigned int             seed) const;

    /** Adds directions() to @p basis again and again until nothing more is
     * found: of parts that are alike a search finds four at most. */
    void extend(ReducedBasis &basis) const;
  };
} // namespace squeal

#endif
