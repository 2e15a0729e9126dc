// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_analyses_limit_cycle_branch_output_h
#define squeal_analyses_limit_cycle_branch_output_h

#include <squeal/cycle/cycle_branch.h>
#include <squeal/results/table.h>

#include <string>

namespace squeal
{
  class RunContext;
  class HtmlReport;
  struct SweepAxisParameters;

  /** One row for each point, from one end to the other. */
  Table branch_table(const CycleBranch              &branch,
                     const std::vector<std::string> &pairs = {});

  /** One sentence: the range, folds and stability. */
  std::string branch_sentence(const CycleBranch &branch,
                              const std::string &parameter);

  /** Where two folds may lie between neighbouring points; empty: nowhere. */
  std::string text_of_hidden_folds(const CycleBranch &branch,
                                   const std::string &parameter);

  /** Amplitude, frequency and largest multiplier over @p axis. */
  void draw_branch(RunContext                &context,
                   const CycleBranch         &branch,
                   const SweepAxisParameters &axis,
                   HtmlReport                &report);
} // namespace squeal

#endif
