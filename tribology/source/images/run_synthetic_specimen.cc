// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/tribology/driver/analyses.h>

namespace squeal::tribology
{
  void
  run_synthetic_specimen(Context &)
  {
    throw InputError("this version does not have the image analyses");
  }
} // namespace squeal::tribology
