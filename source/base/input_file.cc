// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/available_memory.h>
#include <squeal/base/exceptions.h>
#include <squeal/base/files.h>
#include <squeal/base/input_file.h>

#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace squeal
{
  namespace
  {
    /** See input_file_fault(). */
    std::string
    fault_of_mode(const mode_t mode)
    {
      if (S_ISREG(mode))
        return "";
      if (S_ISDIR(mode))
        return "is a directory";
      if (S_ISFIFO(mode))
        return "is a pipe (FIFO), not a file";
      if (S_ISSOCK(mode))
        return "is a socket, not a file";
      return "is a device, not a file";
    }



    [[noreturn]] void
    refuse(const std::string &path, const std::string &reason)
    {
      throw InputError("cannot read '" + path + "': " + reason);
    }



    /** An open file that closes itself. */
    struct Descriptor
    {
      explicit Descriptor(const std::string &path)
        : number(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC))
      {
      }
      ~Descriptor()
      {
        if (number >= 0)
          ::close(number);
      }
      Descriptor(const Descriptor &)            = delete;
      Descriptor &operator=(const Descriptor &) = delete;

      const int number;
    };
  } // namespace



  std::string
  input_file_fault(const std::string &path)
  {
    struct stat status;
    if (::stat(path.c_str(), &status) != 0)
      return errno == ENOENT ? "no such file" : std::strerror(errno);
    return fault_of_mode(status.st_mode);
  }



  void
  require_input_file(const std::string &path)
  {
    const std::string fault = input_file_fault(path);
    // in the words of the system where it has them
    if (fault == "no such file")
      refuse(path, std::strerror(ENOENT));
    if (fault == "is a directory")
      refuse(path, std::strerror(EISDIR));
    if (!fault.empty())
      refuse(path, fault);
  }



  std::string
  read_file(const std::string &path)
  {
    // Asked before it is opened: to open a device can change its state.
    require_input_file(path);
    const Descriptor file(path);
    struct stat      status;
    if (file.number < 0 || ::fstat(file.number, &status) != 0)
      refuse(path, std::strerror(errno));
    // It may have been replaced meanwhile.
    const std::string fault = fault_of_mode(status.st_mode);
    if (!fault.empty())
      refuse(path, fault);
    const double size = static_cast<double>(status.st_size);
    if (size > available_memory())
      refuse(path, "it is larger than the memory that is available");

    // One byte more than it should hold, to see its end without growing; files
    // below /proc say that they are empty.
    constexpr std::size_t block = 1 << 16;
    std::string content(static_cast<std::size_t>(status.st_size) + 1, '\0');
    for (std::size_t n_read = 0;;)
      {
        if (n_read == content.size())
          content.resize(n_read + block);
        const ssize_t n =
          ::read(file.number, &content[n_read], content.size() - n_read);
        if (n < 0 && errno == EINTR)
          continue;
        if (n < 0)
          refuse(path, std::strerror(errno));
        n_read += static_cast<std::size_t>(n);
        if (n == 0)
          {
            content.resize(n_read);
            return content;
          }
      }
  }
} // namespace squeal
