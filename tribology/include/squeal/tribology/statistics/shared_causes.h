// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_statistics_shared_causes_h
#define squeal_tribology_statistics_shared_causes_h

#include <squeal/tribology/setup/damage_parameters.h>
#include <squeal/tribology/statistics/spatial.h>

#include <Eigen/Core>

#include <string>
#include <vector>

namespace squeal::tribology
{
  /** What both maps of a pad follow without a link between them. */
  struct SharedCauses
  {
    /** A row for each cell of the grid, x fastest; the first column is 1. NaN
     * where a measured map is not known. */
    Eigen::MatrixXd values;

    /** Names of the causes, for people. */
    std::vector<std::string> names;

    /** The edge from which the sliding direction points away. */
    LeadingEdge leading_edge = LeadingEdge::lowest_y;
  };

  /** A map that is measured and taken out of both. */
  struct MeasuredCause
  {
    std::string name;
    GridMap     map;
  };

  /** Whether a map has one value wherever it is known, up to rounding. */
  bool is_same_everywhere(const GridMap &map);

  /**
   * The causes that @p choice names, as columns of a regression on the cells of
   * @p grid, whose values do not matter. Distances are those between its
   * columns and rows. The sliding direction points from
   * @p leading_edge, which is not automatic, to the edge on the other side:
   *
   * position  u, u^2, v, v^2, u v, u along the sliding direction, v across it
   * rim       each of the six outermost rings of cells, and a decay from the
   *           rim on over 15 % of the shorter edge
   * edges     the first three rows of cells at the leading edge, a decay over
   *           15 % of the length, even, sloping and bent across; last row;
   *           both outermost columns
   *
   * Each measured map enters as a cubic spline of its values with the knots at
   * their quantiles, of one term for 15 known cells, 2 (with its square) to 8.
   * Throws std::logic_error for
   * the edge "automatic", which tells no place.
   */
  SharedCauses shared_causes(const GridMap                    &grid,
                             const std::vector<SharedCause>   &choice,
                             LeadingEdge                       leading_edge,
                             const std::vector<MeasuredCause> &measured = {});

  /** How much a map that knows nothing but a place resembles another one. */
  struct ReferenceLinks
  {
    double leading_edge = 0.; /**< of a map that decays from that edge on */
    double rim          = 0.; /**< of one that decays from the rim on */
    /** The edge that was taken for the leading one. */
    LeadingEdge edge = LeadingEdge::lowest_y;
  };

  /** Correlations of @p map with a map that concentrates at @p leading_edge,
   * which is not automatic, and with one that concentrates at the rim, each
   * decaying over 15 % of the pad; NaN for a constant map. */
  ReferenceLinks reference_links(const GridMap &map, LeadingEdge leading_edge);
} // namespace squeal::tribology

#endif
