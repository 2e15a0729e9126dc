// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_model_period_map_of_h
#define squeal_model_period_map_of_h

#include <squeal/cycle/period_map.h>
#include <squeal/model/pressed_model.h>

namespace squeal
{
  /** The motions of a scene about its steady sliding. @p about is kept. Throws
   * InputError where a coefficient of friction depends on the slip rate. */
  PeriodMap period_map_of(const SteadyModel &about);
} // namespace squeal

#endif
