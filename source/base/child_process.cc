// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/child_process.h>
#include <squeal/base/exceptions.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <string>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace squeal
{
  namespace
  {
    /** The signals of a crash, which end the child whatever its parent does. */
    constexpr std::array<int, 5> crashes = {
      {SIGSEGV, SIGFPE, SIGBUS, SIGABRT, SIGILL}};

    [[noreturn]] void
    run_child(const std::function<void()> &action)
    {
      for (const int number : crashes)
        std::signal(number, SIG_DFL);
      const int nowhere = ::open("/dev/null", O_WRONLY);
      ::dup2(nowhere, STDOUT_FILENO);
      ::dup2(nowhere, STDERR_FILENO);
      try
        {
          action();
        }
      catch (...)
        {
          // What is wrong is told by the parent, which meets it too.
        }
      ::_exit(0);
    }
  } // namespace



  bool
  ends_by_signal(const std::function<void()> &action)
  {
    const pid_t child = ::fork();
    if (child < 0)
      throw ComputationError(std::string("no process could be started: ") +
                             std::strerror(errno));
    if (child == 0)
      run_child(action);
    int status = 0;
    while (::waitpid(child, &status, 0) < 0)
      if (errno != EINTR)
        throw ComputationError(std::string("a process was lost: ") +
                               std::strerror(errno));
    return WIFSIGNALED(status);
  }
} // namespace squeal
