// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_analyses_transient_transient_verdict_h
#define squeal_analyses_transient_transient_verdict_h

#include <squeal/analyses/transient/transient_results.h>
#include <squeal/contact/pressure_moments.h>

#include <string>

namespace squeal
{
  /** The verdict about steady sliding with what stands beside it: it may be
   * stable, and a limit cycle there all the same. */
  std::string explained_verdict(const TransientFigures &figures,
                                const TriggerOutcome   &trigger);

  /** What the run answers, in a sentence: verdict, growth, limit cycle. */
  std::string transient_headline(const TransientFigures &figures,
                                 const TriggerOutcome   &trigger);

  /** Where the friction that is seen from outside is least, of the table of
   * speeds; empty where none is known. */
  std::string least_friction_text(const Table &speeds);

  /** Whether a vibration stays, by itself or after a trigger, that may be one
   * of the bodies. */
  bool squeals(const TransientFigures &figures, const TriggerOutcome &trigger);

  /** "grows by 1220 +- 0.5 1/s at 6683 Hz" of the leading pair; empty where its
   * fit tells no rate. */
  std::string growth_text(const TransientFigures &figures);

  /** The limit cycle in words, or why there is none. */
  std::string limit_cycle_text(const TransientFigures &figures);

  /** Of a run that has none: what it does instead. */
  std::string reason_for_no_cycle(const TransientFigures &figures);

  /** A limit cycle has settled where its rms changes by no more than this share
   * between the halves of the time that it is taken over. */
  constexpr double settled_rms_change = 0.02;

  /** That samples @p interval, s, apart tell nothing of a motion at
   * @p frequency, Hz, and what is left empty for it. @p is_in_steps: as
   * TransientFigures::is_beyond_in_steps. */
  std::string text_of_sampling(const double frequency,
                               const double interval,
                               const bool   is_in_steps);

  /** Where a moment of the normal forces or that of a node is judged: that it
   * is, and by how much their plain sum vibrates; else empty. */
  std::string text_of_moment(const TransientFigures &figures);

  /** Why the leading pair has no growth rate. */
  std::string reason_for_no_rate(const TransientFigures &figures);

  /** Names the pairs whose fits are left out, since they tell no rate
   * (growth_rule.h) or turn at another frequency; empty if there are none. */
  std::string left_out_text(const TransientFigures &figures);
} // namespace squeal

#endif
