// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_analyses_limit_cycle_cycle_campaign_h
#define squeal_analyses_limit_cycle_cycle_campaign_h

#include <squeal/analyses/limit_cycle/cycle_trials.h>
#include <squeal/parameters/parameters.h>
#include <squeal/results/table.h>

#include <complex>
#include <string>
#include <vector>

namespace squeal
{
  class RunContext;
  class HtmlReport;

  /**
   * The limit cycles of every growing pair at each point of the axes of `Sweep`
   * and for each of `Transient/Tops`: what can be heard, where several pairs
   * grow. Finished points are kept; the same command goes on with the rest.
   */
  void run_cycle_campaign(RunContext &context);

  /** What the cycles of all growing pairs of a point come to. */
  struct CycleOutcome
  {
    std::string text;            /**< in words */
    std::size_t n_converged = 0; /**< pairs that have led to a cycle */
    std::size_t n_different = 0; /**< of those cycles */
    std::size_t n_stable    = 0; /**< different ones that are stable */
    /** The stable one of the largest rms of the normal force; else the only one
     * whose stability is left open; else -1. */
    int heard = -1;
    /** Different ones whose stability is left open. */
    std::vector<int> open;
  };

  /** @p cycles: one for each growing pair; none: steady sliding is stable. Two
   * are the same if frequencies and rms agree within their errors and 0.1 and
   * 1 %. */
  CycleOutcome outcome_of(const std::vector<CycleResult> &cycles);

  /** Columns of what a point comes to, without those of the axes; one row. A
   * cycle that all motions of @p trials end in is heard, whatever multipliers
   * within a hundredth of 1 say; one that is unstable by more is not. One whose
   * stability is left open is not heard where all motions from elsewhere are
   * known to end elsewhere. @p pairs: the contact pairs where there are several, each with
   * its own columns. @p outside: the growth outside the band, 1/s, 0 where there
   * is none: without growing pairs of the band steady sliding is not stable
   * then. */
  Table outcome_table(const std::vector<CycleResult> &cycles,
                      const PointTrials              &trials  = {},
                      const std::vector<std::string> &pairs   = {},
                      const std::complex<double>      outside = 0.);

  /** Of the points of two axes, for each top: which outcome, and the kHz of the
   * cycle that is heard. */
  void draw_cycle_map(RunContext  &context,
                      const Table &points,
                      HtmlReport  &report);

  /** The row of a point without steady sliding. */
  Table outcome_without_sliding(const std::vector<std::string> &pairs = {});
} // namespace squeal

#endif
