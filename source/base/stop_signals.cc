// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/stop_signals.h>

namespace squeal
{
  namespace
  {
    using Ignored = std::array<bool, stop_signals.size()>;

    Ignored
    ignored_now()
    {
      Ignored ignored;
      for (std::size_t i = 0; i < stop_signals.size(); ++i)
        {
          struct sigaction present;
          ::sigaction(stop_signals[i].number, nullptr, &present);
          ignored[i] = present.sa_handler == SIG_IGN;
        }
      return ignored;
    }

    /** Asked before main() starts: MPI sets handlers of its own. */
    const Ignored ignored_at_start = ignored_now();
  } // namespace



  SignalActions
  handle_stop_signals(void (*handler)(int))
  {
    struct sigaction request = {};
    request.sa_handler       = handler;
    ::sigemptyset(&request.sa_mask);
    for (const StopSignal &signal : stop_signals)
      ::sigaddset(&request.sa_mask, signal.number);

    SignalActions former;
    for (std::size_t i = 0; i < stop_signals.size(); ++i)
      {
        const int number = stop_signals[i].number;
        ::sigaction(number, nullptr, &former[i]);
        if (!ignored_at_start[i] || number == SIGTERM || number == SIGINT)
          ::sigaction(number, &request, nullptr);
        else
          ::signal(number, SIG_IGN);
      }
    return former;
  }



  void
  restore_signals(const SignalActions &former)
  {
    for (std::size_t i = 0; i < stop_signals.size(); ++i)
      ::sigaction(stop_signals[i].number, &former[i], nullptr);
  }
} // namespace squeal
