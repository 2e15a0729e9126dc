// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_base_memory_h
#define squeal_base_memory_h

namespace squeal
{
  /** Blocks of vectors come and go all the time: kept by the process, their
   * pages are not cleared by the kernel each time, which took a sixth of a run.
   * To be called once, at the start of a program. */
  void keep_freed_memory();

  /** Gives what was kept back to the system, after a stage that needed much
   * more than the next one. */
  void return_freed_memory();
} // namespace squeal

#endif
