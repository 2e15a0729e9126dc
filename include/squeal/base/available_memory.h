// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_base_available_memory_h
#define squeal_base_available_memory_h

namespace squeal
{
  /** Bytes that this process may still take: what the system has without
   * swapping, the limit of its control group (batch systems, containers) and
   * that of ulimit -v, whichever is least. Infinite where nothing is known. */
  double available_memory();
} // namespace squeal

#endif
