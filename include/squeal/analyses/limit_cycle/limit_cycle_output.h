// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_analyses_limit_cycle_limit_cycle_output_h
#define squeal_analyses_limit_cycle_limit_cycle_output_h

#include <squeal/cycle/cycle_search.h>
#include <squeal/results/table.h>

#include <string>
#include <vector>

namespace squeal
{
  class RunContext;
  class HtmlReport;

  /** One row for each growing pair. @p n_harmonics: those that are written; @p
   * pairs, here and below: the contact pairs where there are several, each with
   * its own columns. */
  Table cycle_table(const std::vector<CycleResult> &cycles,
                    const unsigned int              n_harmonics,
                    const std::vector<std::string> &pairs = {});

  /** Resultants and energy over one period. */
  Table period_table(const CycleResult              &cycle,
                     const std::vector<std::string> &pairs = {});

  /** Amplitudes of the resultants. */
  Table harmonic_table(const CycleResult              &cycle,
                       const unsigned int              n_harmonics,
                       const std::vector<std::string> &pairs = {});

  /** All multipliers above a thousandth. */
  Table multiplier_table(const CycleResult &cycle);

  /** One sentence with the errors of its numbers. */
  std::string cycle_sentence(const CycleResult              &cycle,
                             const std::vector<std::string> &pairs = {});

  /** One period of the resultants and its phase portrait. */
  void draw_cycle(RunContext        &context,
                  const CycleResult &cycle,
                  HtmlReport        &report);
} // namespace squeal

#endif
