// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/standard_streams.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <iostream>

#include <fcntl.h>
#include <unistd.h>

namespace squeal
{
  namespace
  {
    /** Why a stream that has failed fails, by one more line end: its first
     * reason is lost behind the calls since. Empty if it works again. */
    std::string
    reason_of_failed_output()
    {
      std::clearerr(stdout);
      errno = 0;
      if (std::fputc('\n', stdout) != EOF && std::fflush(stdout) == 0)
        return "";
      return std::strerror(errno);
    }
  } // namespace



  void
  occupy_closed_streams()
  {
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
      if (::fcntl(stream, F_GETFD) < 0 && errno == EBADF)
        // The lowest free number is this one, as those before are taken; the
        // wrong direction lets each use fail as on a closed stream.
        if (::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY) !=
            stream)
          return;
  }



  void
  require_printed(const std::string &remark)
  {
    std::cout.flush();
    if (std::cout)
      return;
    const std::string reason = reason_of_failed_output();
    throw InputError("the standard output could not be written" +
                     (reason.empty() ? " in full" : ": " + reason) + remark);
  }
} // namespace squeal
