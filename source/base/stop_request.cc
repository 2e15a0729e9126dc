// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/stop_request.h>

namespace squeal
{
  namespace
  {
    /** A handler reaches nothing but static objects. */
    volatile std::sig_atomic_t signal_noted = 0;

    void
    note(const int signal_number)
    {
      signal_noted = signal_number;
    }
  } // namespace



  StopRequest::StopRequest()
  {
    signal_noted = 0;
    former       = handle_stop_signals(note);
  }

  StopRequest::~StopRequest()
  {
    restore();
  }

  void
  StopRequest::restore()
  {
    if (!active)
      return;
    restore_signals(former);
    active = false;
  }

  bool
  StopRequest::is_there() const
  {
    return signal_noted != 0;
  }

  void
  StopRequest::repeat()
  {
    restore();
    std::raise(signal_noted);
  }
} // namespace squeal
