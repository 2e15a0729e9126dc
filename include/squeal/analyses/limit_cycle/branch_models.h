// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_analyses_limit_cycle_branch_models_h
#define squeal_analyses_limit_cycle_branch_models_h

#include <squeal/cycle/period_maps.h>
#include <squeal/model/pressed_model.h>

namespace squeal
{
  class RunContext;

  /**
   * The motions of the scene along the only axis of `Sweep`, by its coordinate
   * (SweepGrid). Over coefficients of friction all have the modes of @p
   * pressed; over other numbers the bodies are assembled and reduced anew at
   * every value. @p context and @p pressed are kept.
   */
  PeriodMaps branch_maps(RunContext &context, const PressedModel &pressed);
} // namespace squeal

#endif
