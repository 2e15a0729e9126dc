// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_driver_run_context_h
#define squeal_driver_run_context_h

#include <squeal/driver/run_session.h>
#include <squeal/parameters/parameters.h>

namespace squeal
{
  /** What every analysis of a scene shares: its parameters and its session. */
  class RunContext : public RunSession
  {
  public:
    RunContext(const Parameters &parameters, const bool is_root);

    const Parameters &parameters;
  };
} // namespace squeal

#endif
