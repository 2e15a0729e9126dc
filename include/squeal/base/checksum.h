// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_base_checksum_h
#define squeal_base_checksum_h

#include <cstddef>
#include <cstdint>
#include <string>

namespace squeal
{
  /** Of a file that squeal reads back: the checksum below of its bytes from @p
   * start to its end, read in pieces, and their number. Throws InputError. */
  struct FileChecksum
  {
    std::string digits;
    std::size_t size;
  };
  FileChecksum checksum_of_file(const std::string &path, std::size_t start);

  /** CRC-64/XZ of @p size bytes as 16 hexadecimal digits: finds every change of
   * up to 64 bits in a row, and misses one in 2^64 of the others. */
  std::string checksum_of(const char *data, std::size_t size);

  /** The same of a text. */
  std::string checksum_of(const std::string &text);

  /** The same of bytes that come in pieces. */
  class RunningChecksum
  {
  public:
    RunningChecksum();
    void          add(const char *data, std::size_t size);
    std::uint64_t value() const;

  private:
    std::uint64_t remainder; /**< before its last reflection */
  };
} // namespace squeal

#endif
