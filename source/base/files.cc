// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/files.h>
#include <squeal/base/input_file.h>
#include <squeal/base/scratch_directory.h>
#include <squeal/base/state_files.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <streambuf>
#include <vector>

#include <fcntl.h>
#include <fnmatch.h>
#include <unistd.h>

namespace squeal
{
  namespace fs = std::filesystem;

  namespace
  {
    /** Output buffer on a file descriptor that remembers why it failed: the
     * standard file stream loses the reason. */
    class DescriptorBuffer : public std::streambuf
    {
    public:
      explicit DescriptorBuffer(const int descriptor)
        : descriptor(descriptor)
      {
        setp(buffer.data(), buffer.data() + buffer.size());
      }

      int
      error() const
      {
        return error_number;
      }

    protected:
      int_type
      overflow(const int_type c) override
      {
        if (sync() != 0)
          return traits_type::eof();
        if (!traits_type::eq_int_type(c, traits_type::eof()))
          sputc(traits_type::to_char_type(c));
        return traits_type::not_eof(c);
      }

      int
      sync() override
      {
        const char *next = pbase();
        while (next < pptr() && error_number == 0)
          {
            const ssize_t n = ::write(descriptor, next, pptr() - next);
            if (n >= 0)
              next += n;
            else if (errno != EINTR)
              error_number = errno;
          }
        setp(buffer.data(), buffer.data() + buffer.size());
        return error_number == 0 ? 0 : -1;
      }

    private:
      int                         descriptor;
      int                         error_number = 0;
      std::array<char, (1 << 16)> buffer;
    };

    /** Writes through @p writer into @p path; errors name @p shown. */
    void
    write_directly(const std::string                         &path,
                   const std::string                         &shown,
                   const std::function<void(std::ostream &)> &writer)
    {
      const int descriptor =
        ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
      if (descriptor < 0)
        throw InputError("cannot write '" + shown +
                         "': " + std::strerror(errno));

      DescriptorBuffer buffer(descriptor);
      std::ostream     stream(&buffer);
      try
        {
          writer(stream);
        }
      catch (...)
        {
          ::close(descriptor);
          throw;
        }
      stream.flush();
      const int close_error = ::close(descriptor) == 0 ? 0 : errno;
      const int error = buffer.error() != 0 ? buffer.error() : close_error;
      if (error != 0)
        throw InputError("cannot write '" + shown +
                         "': " + std::strerror(error));
    }

    /** Where the bytes of @p path live: links are followed, so that a rename
     * replaces the file and not the link. */
    std::string
    resolved(const std::string &path)
    {
      std::error_code error;
      if (!fs::is_symlink(path, error))
        return path;
      const fs::path real = fs::weakly_canonical(path, error);
      return error ? path : real.string();
    }

  } // namespace



  std::string
  partial_file(const std::string &path)
  {
    const fs::path whole = path;
    return (whole.parent_path() /
            (partial_file_prefix + whole.filename().string()))
      .string();
  }



  AtomicFile::AtomicFile(const std::string &path)
    : target(resolved(path))
    , temporary_name(partial_file(target))
  {
  }



  AtomicFile::~AtomicFile()
  {
    std::error_code ignored;
    if (!committed)
      fs::remove(temporary_name, ignored);
  }



  const std::string &
  AtomicFile::temporary() const
  {
    return temporary_name;
  }



  void
  AtomicFile::commit()
  {
    std::error_code error;
    fs::rename(temporary_name, target, error);
    if (error)
      throw InputError("cannot write '" + target + "': " + error.message());
    committed = true;
  }



  void
  write_atomically(const std::string                         &path,
                   const std::function<void(std::ostream &)> &writer)
  {
    std::error_code ignored;
    if (fs::is_directory(path, ignored))
      throw InputError("cannot write '" + path + "': Is a directory");
    // renaming onto a device would replace the device
    if (fs::exists(path, ignored) && !fs::is_regular_file(path, ignored))
      {
        write_directly(path, path, writer);
        return;
      }
    AtomicFile file(path);
    write_directly(file.temporary(), path, writer);
    file.commit();
  }
} // namespace squeal
