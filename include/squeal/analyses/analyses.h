// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_analyses_analyses_h
#define squeal_analyses_analyses_h

#include <squeal/eigen/complex_pairs.h>
#include <squeal/model/mode_solution.h>
#include <squeal/model/model.h>
#include <squeal/run/run_context.h>

namespace squeal
{
  /** `Analysis = modes`: undamped modes with names and errors. */
  void run_modes(RunContext &context);

  /** `Analysis = cea`: the complex eigenvalue analysis. */
  void run_cea(RunContext &context);

  /** `Analysis = sweep`: complex eigenvalues over ranges of parameters on a
   * certified basis. */
  void run_sweep(RunContext &context);

  /** `Analysis = preload`: steady sliding under the loads. */
  void run_preload(RunContext &context);

  /** `Analysis = transient`: motion in time, one run or a campaign. */
  void run_transient(RunContext &context);

  /** `Analysis = frequency response`: responses between points by
   * superposition of the complex modes. */
  void run_frequency_response(RunContext &context);

  /** `Analysis = updating`: numbers of the scene fitted to measured
   * frequencies. */
  void run_updating(RunContext &context);

  /** `Analysis = work precision`: a ladder of settings, error against work. */
  void run_work_precision(RunContext &context);
} // namespace squeal

#endif
