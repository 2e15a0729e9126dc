// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_source_transient_sliding_flexibility_h
#define squeal_source_transient_sliding_flexibility_h

#include <squeal/contact/contact_nodes.h>

#include <vector>

namespace squeal
{
  /** Shift over cut-off: an error of 6e-8 of the flexibility, while rigid
   * motions, which are taken out again, stand 2e7 above the modes left. */
  constexpr double shift_of_sliding = 2.5e-4;

  /** B A B^T with forces along and across the sliding only at nodes that are
   * at rest, three rows a node; see Flexibility::of_sliding. */
  class SlidingFlexibility
  {
  public:
    explicit SlidingFlexibility(const ContactNodes &nodes);

    /** A unit force a column: 3 nodes x solved. */
    Eigen::MatrixXd forces() const;

    /** All of it, 3 nodes x 3 nodes, symmetric, from its @p columns that belong
     * to the forces. Linear in them. */
    Eigen::MatrixXd complete(const Eigen::MatrixXd &columns) const;

  private:
    Eigen::Index              n_rows;
    std::vector<unsigned int> solved;  /**< rows with a force */
    std::vector<unsigned int> sliding; /**< nodes */
  };
} // namespace squeal

#endif
