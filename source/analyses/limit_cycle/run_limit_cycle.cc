// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/analyses/analyses.h>
namespace squeal
{
  void
  run_limit_cycle(RunContext &)
  {}
} // namespace squeal
