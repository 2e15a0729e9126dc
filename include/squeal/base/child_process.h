// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_base_child_process_h
#define squeal_base_child_process_h

#include <functional>

namespace squeal
{
  /**
   * Does @p action in a child process and tells whether that was ended by a
   * signal (SIGSEGV, SIGFPE, ...): a way to try what may crash inside a library
   * without going down with it. Nothing the child prints is seen, and an
   * exception of the action counts as an orderly end. Only for programs without
   * MPI, which may not be forked. Throws ComputationError where no process can
   * be made.
   */
  bool ends_by_signal(const std::function<void()> &action);
} // namespace squeal

#endif
