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
    signal_noted             = 0;
    struct sigaction request = {};
    request.sa_handler       = note;
    ::sigemptyset(&request.sa_mask);
    ::sigaction(SIGTERM, &request, &former_term);
    ::sigaction(SIGINT, &request, &former_int);
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
    ::sigaction(SIGTERM, &former_term, nullptr);
    ::sigaction(SIGINT, &former_int, nullptr);
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
