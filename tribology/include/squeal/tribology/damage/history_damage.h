// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_damage_history_damage_h
#define squeal_tribology_damage_history_damage_h

#include <squeal/tribology/damage/peak_loss.h>
#include <squeal/tribology/damage/surface.h>
#include <squeal/tribology/fatigue/damage_counter.h>
#include <squeal/tribology/history/contact_grid.h>

#include <functional>
#include <memory>
#include <vector>

namespace squeal::tribology
{
  /** All that one pass over a history says about each node. */
  struct HistoryDamage
  {
    struct Node
    {
      /** Share of the life that the history takes where it repeats, for each
       * curve: of its own stress. */
      std::vector<double> damage;
      /** Relative standard error of that by SamplingError, NaN: not known. */
      std::vector<double> sampling_error;
      std::vector<double> averaged; /**< of the averaged stress */
      std::vector<double> dirlik;   /**< 1/s, empty if not asked for */
      /** What is counted to compare with it: on straight S-N lines, without
       * mean stress, by Miner's sum. */
      std::vector<double> straight;
      double              cycles        = 0.;
      double              largest_range = 0.; /**< Pa */
      SurfaceSums         surface;
    };

    /** The node with the largest damage of exponent number @p curve; of the
     * first one headlines and pictures speak. The first of several alike. */
    std::size_t worst_node(std::size_t curve = 0) const;

    double duration = 0.; /**< s, from the first to the last sample */
    /** Time that the counted cycles take, s: the duration, or the period of a
     * history that repeats. Damage and cycles per second are over this. */
    double period = 0.;
    /** Of the mean damage of the largest exponent (PeakLoss). */
    LostDamage lost;
    /** Relative standard errors of the mean damage, for each curve, and the
     * least of the peaks of the face in quarters of the history, Pa; NaN where
     * these are not known. */
    std::vector<double> sampling_error;
    double              least_peak    = 0.;
    bool                has_slip_rate = false; /**< in the history */
    bool has_stick_slip = false; /**< it tells sticking from slipping */
    std::uint64_t                samples = 0;
    std::size_t                  deepest = 0; /**< points kept by a counter */
    std::vector<Node>            nodes;
    std::vector<RangeMeanMatrix> matrices; /**< one a node */
    std::vector<std::string>     notes;    /**< what a reader has to know */
  };

  /** What is read of a history. */
  struct HistoryWindow
  {
    std::uint64_t first = 0;
    std::uint64_t n     = 0;
  };

  /** The samples that the section "History" asks for. Throws InputError if
   * there are fewer than two. */
  HistoryWindow history_window(const HistoryReader     &reader,
                               const HistoryParameters &parameters);

  /** Calls @p action with pieces of the window in order. */
  void for_each_chunk(
    const HistoryReader                               &reader,
    const HistoryWindow                               &window,
    std::size_t                                        n_chunk,
    const std::function<void(const HistorySamples &)> &action);

  /**
   * Counts a history in one pass: the stress of each node (a pressure counts as
   * compression), that of its neighbourhood averaged over `Averaging length`,
   * and the surface figures. Memory does not grow with the length.
   */
  HistoryDamage count_history(
    const HistoryReader                    &reader,
    const HistoryParameters                &history,
    const FatigueParameters                &fatigue,
    const SurfaceParameters                &surface,
    const ContactGrid                      &grid,
    const std::function<void(std::size_t)> &progress = {});
} // namespace squeal::tribology

#endif
