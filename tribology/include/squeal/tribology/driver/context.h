// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_driver_context_h
#define squeal_tribology_driver_context_h

#include <squeal/run/run_session.h>
#include <squeal/tribology/setup/tribology_parameters.h>

#include <string>

namespace squeal::tribology
{
  /** What every analysis shares: its parameters and its session. */
  class Context : public RunSession
  {
  public:
    explicit Context(const TribologyParameters &parameters,
                     const RunOptions          &options = {});

    /** Announces plots/name.png and returns its path without the ending. */
    std::string plot_path(const std::string &name);

    const TribologyParameters &parameters;
  };
} // namespace squeal::tribology

#endif
