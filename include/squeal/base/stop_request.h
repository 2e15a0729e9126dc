// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_base_stop_request_h
#define squeal_base_stop_request_h

#include <squeal/base/stop_signals.h>

namespace squeal
{
  /**
   * While it lives, the stop signals (see stop_signals.h) only leave a note, so
   * that a long computation can save its state between two steps; what a write
   * lacks because of one is told by whoever writes. repeat() hands the signal
   * to whoever handled it before (see InterruptGuard). At most one may live at
   * a time.
   */
  class StopRequest
  {
  public:
    StopRequest();
    ~StopRequest();
    StopRequest(const StopRequest &)            = delete;
    StopRequest &operator=(const StopRequest &) = delete;

    bool is_there() const;

    /** Puts the former handlers back and raises the signal again. */
    void repeat();

  private:
    void restore();

    SignalActions former;
    bool          active = true;
  };
} // namespace squeal

#endif
