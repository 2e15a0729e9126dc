// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_base_stop_request_h
#define squeal_base_stop_request_h

#include <csignal>

namespace squeal
{
  /**
   * While it lives, SIGTERM and SIGINT only leave a note, so that a long
   * computation can save its state between two steps. repeat() hands the signal
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

    struct sigaction former_term, former_int;
    bool             active = true;
  };
} // namespace squeal

#endif
