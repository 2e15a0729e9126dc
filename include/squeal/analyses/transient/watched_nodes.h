// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_analyses_transient_watched_nodes_h
#define squeal_analyses_transient_watched_nodes_h

#include <squeal/analyses/transient/force_statistics.h>
#include <squeal/contact/contact_nodes.h>

#include <Eigen/Dense>

#include <vector>

namespace squeal
{
  /**
   * The normal forces of some nodes of each pair, spread over its face, one by
   * one. A wave with two or more wave lengths round a ring or along a pad
   * cancels in the sum of all nodes and in both moments.
   */
  struct WatchedNodes
  {
    /** Of each pair: more tell shorter waves, and need more memory; so that
     * waves of ten wave lengths round a ring are seen at six nodes each. */
    static constexpr unsigned int most_nodes = 64;

    /** Steps that are kept one by one, at the end of a run: lines above what
     * samples tell have many periods in them. */
    static constexpr unsigned int most_last_steps = 8192;

    WatchedNodes() = default;
    explicit WatchedNodes(const ContactNodes &nodes);

    /** Numbers among the nodes of all pairs, pair after pair. */
    std::vector<unsigned int> numbers;
    /** Nodes x n_force_stretches: the normal forces of every step, N. */
    std::vector<SignalPiece> pieces;
    /** Nodes x n_trigger_stretches, as those of
     * TransientRecord::trigger_stretches; empty without a trigger. */
    std::vector<SignalPiece> trigger_pieces;
    /** Normal forces, N, samples x nodes and last steps x nodes. */
    std::vector<double> samples, last_steps;

    /** Adds a step to stretch number @p stretch of @p forces, three a node of
     * all pairs, N. */
    void add_step(const Eigen::VectorXd &forces,
                  const unsigned int     stretch,
                  const bool             is_one_of_the_last);
    void add_sample(const Eigen::VectorXd &forces);
    /** The same step, to stretch number @p stretch of those that tell what a
     * trigger has made. */
    void add_trigger_step(const Eigen::VectorXd &forces,
                          const unsigned int     stretch);

    /** What node number @p i of this list is in every row of @p rows, `samples`
     * or `last_steps`. */
    std::vector<double> series(const std::vector<double> &rows,
                               const std::size_t          i) const;
    /** Of node number @p i of this list, from stretch number @p first up to the
     * one before @p end. */
    std::vector<SignalPiece> pieces_of(const std::size_t  i,
                                       const unsigned int first,
                                       const unsigned int end) const;
    /** Root of the mean square about the mean there, N. */
    double rms(const std::size_t  i,
               const unsigned int first,
               const unsigned int end) const;
  };

  /** What the nodes of a pair vibrate by in the quarters of some stretches
   * beside the slow part of each, N. */
  struct NodeVibrations
  {
    /** Four: the sum over all nodes of the pair, by those that are watched; 0
     * where none is. That of the sum of forces that vibrate in step. */
    std::vector<double> all{0., 0., 0., 0.};
    std::size_t         loudest = 0;                /**< in WatchedNodes */
    std::vector<double> of_loudest{0., 0., 0., 0.}; /**< its own */
    /** How often its samples cross their slow part: twice a period. */
    unsigned int n_crossings = 0;
  };

  /** Of @p pair, from stretch number @p first up to the one before @p end. */
  NodeVibrations vibrations_of_nodes(const WatchedNodes &nodes,
                                     const ContactPair  &pair,
                                     const unsigned int  first,
                                     const unsigned int  end);
} // namespace squeal

#endif
