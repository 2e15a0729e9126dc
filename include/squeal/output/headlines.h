// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_output_headlines_h
#define squeal_output_headlines_h

#include <squeal/parameters/parameters.h>
#include <squeal/results/table.h>

#include <string>

namespace squeal
{
  /**
   * @name First sentences
   * What stands at the top of a report: the answer to the question of the
   * analysis, with its largest error. They are made of the tables that the run
   * has written, so that they cannot say anything else; where a table has no
   * answer they say so.
   */
  //@{
  /** "squeals in 70.3 % of 400 samples (95 %: 65.6 to 74.5 %)" of
   * scatter.csv. */
  std::string scatter_headline(const Table &probabilities);

  /** The smallest change that a direct solution has found to be stable, of the
   * worst pair first, and what it tunes in: of suggestions.csv. */
  std::string suggestion_headline(const Table           &suggestions,
                                  const SceneParameters &scene);

  /** Which runs squeal by themselves, which after the trigger, which vibrate
   * for a while: of a campaign's table with the column "outcome". */
  std::string trigger_headline(const Table           &campaign,
                               const SweepParameters &sweep,
                               const SceneParameters &scene);

  /** How many runs grow and end in a limit cycle, and at which frequencies: of
   * any other campaign's table. */
  std::string campaign_headline(const Table &campaign);

  /** The friction that is seen from outside over the first axis, a sliding
   * speed, for every value of the others; empty where no run has one. */
  std::string friction_headline(const Table           &campaign,
                                const SweepParameters &sweep,
                                const SceneParameters &scene);

  /** How far growth in time and eigenvalues lie apart: of a campaign's table
   * with the column "rate_difference". */
  std::string comparison_headline(const Table &campaign);

  /** What the least work for the asked error is, and the other ladders beside
   * it: of cost_at_error.csv. */
  std::string work_headline(const Table &costs);

  /** Which figure of which ladder is worst, and what the asked error takes: of
   * figure_costs.csv. */
  std::string figure_headline(const Table &costs);

  /** The three largest resonances of mode_participation.csv, whose peaks are in
   * @p unit. */
  std::string resonance_headline(const Table       &participation,
                                 const std::string &unit);

  /** Where the loudest range of unstable_ranges.csv lies, in words; of stable
   * scenes with a mesh that nothing is known of what it does to growth rates.
   */
  std::string range_headline(const Table           &ranges,
                             const SweepParameters &sweep,
                             const SceneParameters &scene,
                             const bool             is_meshed);
  //@}
} // namespace squeal

#endif
