// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_run_run_context_h
#define squeal_run_run_context_h

#include <squeal/parameters/parameters.h>
#include <squeal/run/run_session.h>

namespace squeal
{
  /** What every analysis of a scene shares: its parameters and its session. */
  class RunContext : public RunSession
  {
  public:
    RunContext(const Parameters &parameters,
               const bool        is_root,
               const RunOptions &options = {});

    const Parameters &parameters;
  };
} // namespace squeal

#endif
