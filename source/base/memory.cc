// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/memory.h>

#include <malloc.h>

namespace squeal
{
  void
  keep_freed_memory()
  {
    // MPI switches mapped blocks off; large bases need them to grow in place
    // and to leave no holes.
    mallopt(M_MMAP_MAX, 65536);
    mallopt(M_MMAP_THRESHOLD, 32 << 20);
    mallopt(M_TRIM_THRESHOLD, 1 << 30);
    mallopt(M_TOP_PAD, 64 << 20);
  }

  void
  return_freed_memory()
  {
    malloc_trim(0);
  }
} // namespace squeal
