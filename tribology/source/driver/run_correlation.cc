// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/tribology/driver/analyses.h>

namespace squeal::tribology
{
  void
  run_correlation(Context &)
  {
    throw InputError("this version does not have this analysis");
  }
} // namespace squeal::tribology
