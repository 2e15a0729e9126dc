// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/row_file.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace squeal
{
  namespace
  {
    constexpr std::size_t head_size = 512, buffer_size = 1 << 20;
    /** A checksum as two numbers that are whole in double. */
    constexpr std::uint64_t half = std::uint64_t(1) << 32;

    std::string
    head_of(const std::string &kind)
    {
      std::string head = "squeal " + kind + "\n";
      head.resize(head_size, '\0');
      return head;
    }
  } // namespace



  RowFile::RowFile(const std::string &path,
                   const std::string &kind,
                   const std::size_t  columns)
    : name(path)
    , head(head_of(kind))
    , n_columns(columns)
  {
  }

  RowFile::~RowFile()
  {
    if (descriptor >= 0)
      ::close(descriptor);
  }



  void
  RowFile::fail(const std::string &what) const
  {
    throw InputError("'" + name + "': " + what);
  }

  void
  RowFile::open(const int flags)
  {
    if (descriptor >= 0)
      ::close(descriptor);
    descriptor = ::open(name.c_str(), O_RDWR | O_CLOEXEC | flags, 0666);
    if (descriptor < 0)
      fail(std::strerror(errno));
  }



  void
  RowFile::start()
  {
    open(O_CREAT | O_TRUNC);
    rows     = 0;
    checksum = {};
    buffer.assign(head.begin(), head.end());
    flush();
  }



  void
  RowFile::append(const std::vector<double> &values)
  {
    Assert(descriptor >= 0 && values.size() % n_columns == 0,
           dealii::ExcInternalError());
    const char       *bytes = reinterpret_cast<const char *>(values.data());
    const std::size_t n     = values.size() * sizeof(double);
    checksum.add(bytes, n);
    buffer.insert(buffer.end(), bytes, bytes + n);
    rows += values.size() / n_columns;
    if (buffer.size() >= buffer_size)
      flush();
  }



  void
  RowFile::flush() const
  {
    for (std::size_t done = 0; done < buffer.size();)
      {
        const ssize_t n =
          ::write(descriptor, buffer.data() + done, buffer.size() - done);
        if (n < 0 && errno == EINTR)
          continue;
        if (n < 0)
          fail(std::string("cannot be written: ") + std::strerror(errno));
        done += n;
      }
    buffer.clear();
  }



  std::size_t
  RowFile::n_rows() const
  {
    return rows;
  }



  std::vector<double>
  RowFile::read(const std::size_t first, const std::size_t n) const
  {
    Assert(first + n <= rows, dealii::ExcInternalError());
    flush();
    std::vector<double> values(n * n_columns);
    char               *bytes = reinterpret_cast<char *>(values.data());
    const std::size_t   size  = values.size() * sizeof(double),
                      start   = head_size + first * n_columns * sizeof(double);
    for (std::size_t done = 0; done < size;)
      {
        const ssize_t got =
          ::pread(descriptor, bytes + done, size - done, start + done);
        if (got < 0 && errno == EINTR)
          continue;
        if (got <= 0)
          fail(got == 0
                 ? std::string("is cut off")
                 : std::string("cannot be read: ") + std::strerror(errno));
        done += got;
      }
    return values;
  }



  NamedNumbers
  RowFile::memory()
  {
    flush();
    if (::fsync(descriptor) != 0)
      fail(std::string("cannot be written: ") + std::strerror(errno));
    NamedNumbers result;
    result.set("rows", static_cast<double>(rows));
    result.set(
      "checksum",
      std::vector<double>{static_cast<double>(checksum.value() / half),
                          static_cast<double>(checksum.value() % half)});
    return result;
  }



  RunningChecksum
  RowFile::checksum_of_rows(const std::size_t n_bytes) const
  {
    RunningChecksum   result;
    std::vector<char> piece(std::min(n_bytes, buffer_size));
    for (std::size_t done = 0; done < n_bytes;)
      {
        const ssize_t got = ::pread(descriptor,
                                    piece.data(),
                                    std::min(piece.size(), n_bytes - done),
                                    head_size + done);
        if (got < 0 && errno == EINTR)
          continue;
        if (got <= 0)
          fail("has fewer rows than its checkpoint");
        result.add(piece.data(), got);
        done += got;
      }
    return result;
  }



  void
  RowFile::restore(const NamedNumbers &memory)
  {
    open(0);
    std::string found(head_size, '\0');
    if (::pread(descriptor, found.data(), head_size, 0) !=
          static_cast<ssize_t>(head_size) ||
        found != head)
      fail("is not what its name says");
    struct stat       status;
    const std::size_t row_size = n_columns * sizeof(double);
    if (::fstat(descriptor, &status) != 0)
      fail(std::strerror(errno));
    const std::size_t most =
      (static_cast<std::size_t>(status.st_size) - head_size) / row_size;
    const double asked = memory.number("rows");
    if (!(asked <= static_cast<double>(most)))
      fail("has fewer rows than its checkpoint");
    const std::size_t     n       = memory.count("rows", most);
    const auto           &digits  = memory.get("checksum", 2);
    const RunningChecksum of_rows = checksum_of_rows(n * row_size);
    if (static_cast<double>(of_rows.value() / half) != digits[0] ||
        static_cast<double>(of_rows.value() % half) != digits[1])
      fail("has other rows than its checkpoint");
    const auto end = static_cast<off_t>(head_size + n * row_size);
    if (::ftruncate(descriptor, end) != 0 ||
        ::lseek(descriptor, end, SEEK_SET) != end)
      fail(std::string("cannot be written: ") + std::strerror(errno));
    rows     = n;
    checksum = of_rows;
    buffer.clear();
  }



  void
  RowFile::remove()
  {
    if (descriptor < 0)
      return;
    ::close(descriptor);
    descriptor = -1;
    ::unlink(name.c_str());
  }

  const std::string &
  RowFile::path() const
  {
    return name;
  }
} // namespace squeal
