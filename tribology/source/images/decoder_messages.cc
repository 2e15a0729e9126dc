// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/tribology/images/decoder_messages.h>

#include <cstdio>
#include <mutex>
#include <sstream>

#include <sys/mman.h>
#include <unistd.h>

namespace squeal::tribology
{
  namespace
  {
    constexpr std::size_t longest = 65536; // bytes kept of the messages

    /** The standard error stream in a file, until the end of its scope. */
    class ErrorsInFile
    {
    public:
      ErrorsInFile()
        : file(::memfd_create("messages", MFD_CLOEXEC))
        , terminal(::dup(STDERR_FILENO))
      {
        std::fflush(stderr);
        if (file >= 0 && terminal >= 0)
          ::dup2(file, STDERR_FILENO);
      }

      ~ErrorsInFile()
      {
        std::fflush(stderr);
        if (file >= 0 && terminal >= 0)
          ::dup2(terminal, STDERR_FILENO);
        for (const int open : {file, terminal})
          if (open >= 0)
            ::close(open);
      }

      ErrorsInFile(const ErrorsInFile &)            = delete;
      ErrorsInFile &operator=(const ErrorsInFile &) = delete;

      std::string
      text() const
      {
        std::fflush(stderr);
        std::string   result(longest, '\0');
        const ssize_t n = ::pread(file, &result[0], result.size(), 0);
        result.resize(n > 0 ? n : 0);
        return result;
      }

    private:
      const int file, terminal;
    };
  } // namespace



  std::string
  messages_of(const std::function<void()> &action)
  {
    static std::recursive_mutex                 one_at_a_time;
    const std::lock_guard<std::recursive_mutex> lock(one_at_a_time);
    const ErrorsInFile                          errors;
    action();
    return errors.text();
  }



  std::string
  damage_in(const std::string &messages)
  {
    std::istringstream in(messages);
    for (std::string line; std::getline(in, line);)
      for (const char *damage : {"Corrupt JPEG data",
                                 "Premature end of JPEG",
                                 "Invalid SOS parameters",
                                 "libpng error",
                                 "CRC error",
                                 "Read error on",
                                 "Not enough data",
                                 "Corrupted",
                                 "Fax3Decode",
                                 "LZWDecode",
                                 "ZIPDecode",
                                 "PackBitsDecode"})
        if (line.find(damage) != std::string::npos)
          return line;
    return "";
  }
} // namespace squeal::tribology
