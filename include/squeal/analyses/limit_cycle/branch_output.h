// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_analyses_limit_cycle_branch_output_h
#define squeal_analyses_limit_cycle_branch_output_h

#include <squeal/analyses/limit_cycle/axis_search.h>
#include <squeal/results/table.h>

#include <string>

namespace squeal
{
  class RunContext;
  class HtmlReport;
  struct SweepAxisParameters;

  /** One row for each point, branch after branch from one end to the other. */
  Table branch_table(const BranchDiagram            &diagram,
                     const std::vector<std::string> &pairs);

  /** One sentence: the range, folds and stability. */
  std::string branch_sentence(const CycleBranch &branch,
                              const std::string &parameter);

  /** Of a single branch that; of several what they have together, and what the
   * searches beside them have come to. */
  std::string diagram_sentence(const BranchDiagram &diagram,
                               const std::string   &parameter);

  /** Where two folds may lie between neighbouring points; empty: nowhere. */
  std::string text_of_hidden_folds(const BranchDiagram &diagram,
                                   const std::string   &parameter);

  /** Amplitude, frequency and largest multiplier over @p axis, and what the
   * searches have come to. */
  void draw_branches(RunContext                &context,
                     const BranchDiagram       &diagram,
                     const SweepAxisParameters &axis,
                     HtmlReport                &report);
} // namespace squeal

#endif
