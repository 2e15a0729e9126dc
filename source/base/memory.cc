// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/memory.h>

#include <malloc.h>

namespace squeal
{
  void
  keep_freed_memory()
  {
    // A block that is mapped for itself is cleared page by page whenever it is
    // allocated: a fifth of the time of an analysis.
    mallopt(M_MMAP_MAX, 0);
    mallopt(M_TRIM_THRESHOLD, 1 << 30);
    mallopt(M_TOP_PAD, 64 << 20);
  }

  void
  return_freed_memory()
  {
    malloc_trim(0);
  }
} // namespace squeal
