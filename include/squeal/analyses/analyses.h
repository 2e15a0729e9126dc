// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_analyses_analyses_h
#define squeal_analyses_analyses_h

#include <squeal/base/unknown_choice.h>
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

  /** `Analysis = limit cycle`: periodic motions and their stability. */
  void run_limit_cycle(RunContext &context);

  /** `Analysis = frequency response`: responses between points by
   * superposition of the complex modes. */
  void run_frequency_response(RunContext &context);

  /** `Analysis = updating`: numbers of the scene fitted to measured
   * frequencies. */
  void run_updating(RunContext &context);

  /** `Analysis = angles`: complex eigenvalues over the angles of a rotor that
   * is no body of revolution. */
  void run_angles(RunContext &context);

  /** `Analysis = operating matrix`: which pairs squeal at which pressure,
   * temperature, speed and sense of turning. */
  void run_operating_matrix(RunContext &context);

  /** `Analysis = triggers`: smallest impulses that lead to squeal, and the
   * unstable cycle on the edge. */
  void run_triggers(RunContext &context);

  /** `Analysis = work precision`: a ladder of settings, error against work. */
  void run_work_precision(RunContext &context);

  /** The analysis that the parameters ask for. */
  inline void
  run_analysis(RunContext &context)
  {
    switch (context.parameters.analysis)
      {
      case Parameters::Analysis::modes:
        return run_modes(context);
      case Parameters::Analysis::cea:
        return run_cea(context);
      case Parameters::Analysis::sweep:
        return run_sweep(context);
      case Parameters::Analysis::preload:
        return run_preload(context);
      case Parameters::Analysis::transient:
        return run_transient(context);
      case Parameters::Analysis::work_precision:
        return run_work_precision(context);
      case Parameters::Analysis::frequency_response:
        return run_frequency_response(context);
      case Parameters::Analysis::updating:
        return run_updating(context);
      case Parameters::Analysis::angles:
        return run_angles(context);
      case Parameters::Analysis::limit_cycle:
        return run_limit_cycle(context);
      case Parameters::Analysis::operating_matrix:
        return run_operating_matrix(context);
      case Parameters::Analysis::triggers:
        return run_triggers(context);
      }
    unknown_choice("analysis");
  }
} // namespace squeal

#endif
