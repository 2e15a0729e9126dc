// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/file_lock.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace squeal
{
  namespace
  {
    const std::string owner_mark = "# owner: ";

    /** "process 12 on host" of the file, as its owner has written it. */
    std::string
    owner_of(const std::string &path)
    {
      std::ifstream in(path);
      for (std::string line; std::getline(in, line);)
        if (line.rfind(owner_mark, 0) == 0)
          return line.substr(owner_mark.size());
      return "another process";
    }

    std::string
    this_process()
    {
      std::array<char, 256> host = {};
      ::gethostname(host.data(), host.size() - 1);
      return "process " + std::to_string(::getpid()) + " on " + host.data();
    }
  } // namespace



  FileLock::FileLock(const std::string &path, const std::string &what)
    : path(path)
  {
    made       = ::access(path.c_str(), F_OK) != 0;
    descriptor = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (descriptor < 0)
      throw InputError("cannot write '" + path + "': " + std::strerror(errno));
    int result;
    do
      result = ::flock(descriptor, LOCK_EX | LOCK_NB);
    while (result != 0 && errno == EINTR);
    if (result == 0)
      return;
    if (errno == EWOULDBLOCK)
      {
        ::close(descriptor);
        throw InputError(what + " is in use by " + owner_of(path) +
                         ": wait for its end or choose another Output "
                         "directory");
      }
    held = false;
  }



  FileLock::~FileLock()
  {
    ::close(descriptor);
  }

  bool
  FileLock::is_held() const
  {
    return held;
  }

  bool
  FileLock::is_new() const
  {
    return made;
  }



  void
  FileLock::rewrite(const std::string &head) const
  {
    const std::string text = head + '\n' + owner_mark + this_process() + '\n';
    if (::ftruncate(descriptor, 0) != 0 ||
        ::pwrite(descriptor, text.data(), text.size(), 0) !=
          static_cast<ssize_t>(text.size()))
      throw InputError("cannot write '" + path + "': " + std::strerror(errno));
  }



  void
  FileLock::append(const std::string &line) const
  {
    const std::string text = line + '\n';
    if (::lseek(descriptor, 0, SEEK_END) < 0 ||
        ::write(descriptor, text.data(), text.size()) !=
          static_cast<ssize_t>(text.size()))
      throw InputError("cannot write '" + path + "': " + std::strerror(errno));
  }



  bool
  FileLock::is_in_place() const
  {
    struct stat own = {}, there = {};
    return ::fstat(descriptor, &own) == 0 &&
           ::stat(path.c_str(), &there) == 0 && own.st_dev == there.st_dev &&
           own.st_ino == there.st_ino;
  }
} // namespace squeal
