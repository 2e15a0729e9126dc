// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_analyses_transient_force_sums_h
#define squeal_analyses_transient_force_sums_h

#include <squeal/analyses/transient/force_statistics.h>
#include <squeal/contact/contact_nodes.h>

#include <Eigen/Dense>

#include <vector>

namespace squeal
{
  /** Sums of contact forces over nodes, as linear functions of all of them. */
  class ForceSums
  {
  public:
    explicit ForceSums(const ContactNodes &nodes);

    /** Of @p forces, N, three a node of all pairs: over the pairs that slide
     * (over all where none does). @p backwards: the target slides against its
     * direction, so that the other edge leads. StepSums::edge is NaN where no
     * pair has such an edge. */
    StepSums of(const Eigen::VectorXd &forces,
                const bool             backwards = false) const;

    /** Forces and moments of each pair, the other members 0; empty with one
     * pair. */
    std::vector<StepSums> of_pairs(const Eigen::VectorXd &forces) const;

    /** PressureMoments of pair @p i, N. */
    Eigen::Vector2d moments(const std::size_t      i,
                            const Eigen::VectorXd &forces) const;

  private:
    /** One pair. */
    struct Pair
    {
      Eigen::Index    first; /**< of its forces among all */
      Eigen::MatrixXd rows;  /**< along the sliding and normal, 2 x three a node
                                of it */
      Eigen::MatrixXd moments; /**< PressureMoments::rows */
    };

    /** A column each: StepSums::tangential and normal, edge while the target
     * slides forwards and while it slides backwards, pressing and friction. */
    Eigen::MatrixXd   all;
    std::vector<Pair> pairs;
  };
} // namespace squeal

#endif
