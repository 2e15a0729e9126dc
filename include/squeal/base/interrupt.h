// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_base_interrupt_h
#define squeal_base_interrupt_h

#include <string>

namespace squeal
{
  /**
   * While it lives, stop signals (stop_signals.h) end the program in order: the
   * files that the manifest of the output directory lists, complete or not, are
   * removed but for the log, one line on stderr says so, and the exit code is
   * 128 + the number of the signal. At most one may live at a time.
   *
   * The handler runs on the main thread, which therefore writes nothing
   * meanwhile, and calls async-signal-safe functions only.
   */
  class InterruptGuard
  {
  public:
    /** @p directory as OutputDirectory::path(); ranks other than the root end
     * in silence and remove nothing. */
    InterruptGuard(const std::string &directory, const bool is_root);
    ~InterruptGuard();
    InterruptGuard(const InterruptGuard &)            = delete;
    InterruptGuard &operator=(const InterruptGuard &) = delete;
  };
} // namespace squeal

#endif
