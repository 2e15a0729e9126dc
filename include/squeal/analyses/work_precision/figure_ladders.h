// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_analyses_work_precision_figure_ladders_h
#define squeal_analyses_work_precision_figure_ladders_h

namespace squeal
{
  class RunContext;

  /** `Analysis = work precision` of steady sliding and of transients: each
   * ladder is climbed from the settings of the file, and its figures are
   * compared with those of its own finest rung. */
  void run_figure_ladders(RunContext &context);
} // namespace squeal

#endif
