// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_base_stop_signals_h
#define squeal_base_stop_signals_h

#include <array>
#include <csignal>

namespace squeal
{
  /** A signal that ends a run in order, and what to call it in the line that
   * says so. */
  struct StopSignal
  {
    int         number;
    const char *name;
  };

  constexpr std::array<StopSignal, 7> stop_signals = {
    {{SIGTERM, "SIGTERM"},
     {SIGINT, "SIGINT"},
     {SIGHUP, "SIGHUP"},
     {SIGQUIT, "SIGQUIT"},
     {SIGPIPE, "SIGPIPE (nobody reads the output any more)"},
     {SIGXFSZ, "SIGXFSZ (a file reached the size limit, see ulimit -f)"},
     {SIGXCPU, "SIGXCPU (the limit of CPU time, see ulimit -t)"}}};

  /** What was done with each of them before. */
  using SignalActions = std::array<struct sigaction, stop_signals.size()>;

  /**
   * Has @p handler called for all stop signals, one at a time, and returns what
   * was done with them before. A signal that the one who started the program
   * had ignored (nohup: SIGHUP) stays ignored, but for SIGTERM and SIGINT: a
   * shell ignores the latter for all that it starts in the background.
   */
  SignalActions handle_stop_signals(void (*handler)(int));

  /** Puts back what handle_stop_signals() returned. */
  void restore_signals(const SignalActions &former);
} // namespace squeal

#endif
