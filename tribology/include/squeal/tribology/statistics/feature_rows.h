// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_statistics_feature_rows_h
#define squeal_tribology_statistics_feature_rows_h

#include <squeal/tribology/history/contact_grid.h>

#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace squeal::tribology
{
  /** How the rows of a table of features lie on the nodal cells of a pad. */
  struct FeatureRows
  {
    /** What a row tells of a node. */
    struct Share
    {
      std::size_t row = 0, node = 0;
      double      part = 0.; /**< of the node's cell, 0 to 1 */
    };

    /** Cells that are more than so many times as long as those of the nodes
     * say nothing of each node by itself. */
    static constexpr double coarse = 1.5;

    std::vector<Share> shares;

    /** Larger one of the ratios of the rows' spacing to the mean spacing of the
     * nodes, along x and y; NaN where the rows stand at nodes or on no even
     * lattice. */
    double coarseness = NAN;
  };

  /**
   * Shares rows at @p places (x and y, m) among the nodes of @p grid, which is
   * rectangular. Rows that stand at nodes belong to them as a whole. Rows on a
   * lattice with even steps along x and y, of which some may be missing, are
   * rectangles as large as the steps, in one column in the middle of the face
   * as wide as the face, a single row there as large as the face even where it
   * stands at a node, and each node takes the part of its cell
   * that a rectangle covers. Rectangles that are coarse and other rows are
   * points that tell of the whole cell in which they lie, on a border of those
   * on both sides.
   * Throws InputError, beginning with @p where of the row, for a place beside
   * the face.
   */
  FeatureRows share_rows(const ContactGrid                             &grid,
                         const std::vector<std::array<double, 2>>      &places,
                         const std::function<std::string(std::size_t)> &where);
} // namespace squeal::tribology

#endif
