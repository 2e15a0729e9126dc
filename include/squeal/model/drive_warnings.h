// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_model_drive_warnings_h
#define squeal_model_drive_warnings_h

#include <squeal/parameters/parameters.h>

namespace squeal
{
  class RunLog;

  /** Warns of what the entries of a motion in time say about its drive and the
   * run does not do, or cannot tell apart: ramps of loads that are there from
   * the start, and a trigger while a load still comes on. */
  void warn_of_drive(const Parameters &parameters, RunLog &log);
} // namespace squeal

#endif
