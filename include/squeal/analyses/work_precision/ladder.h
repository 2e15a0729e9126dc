// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_analyses_work_precision_ladder_h
#define squeal_analyses_work_precision_ladder_h

#include <squeal/parameters/parameters.h>

#include <string>

namespace squeal
{
  /** The parameters of one rung: @p all with @p value for what @p ladder
   * varies. Throws InputError where that is none that can be solved. */
  Parameters parameters_of_rung(const Parameters                     &all,
                                const WorkPrecisionParameters::Ladder ladder,
                                const double                          value);

  /** "cells = 2", in the words of parameter files. */
  std::string setting_text(const WorkPrecisionParameters::Ladder ladder,
                           const double                          value);
} // namespace squeal

#endif
