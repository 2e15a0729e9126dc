// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/checksum.h>
#include <squeal/base/exceptions.h>
#include <squeal/base/input_file.h>

#include <boost/crc.hpp>

#include <array>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <vector>

namespace squeal
{
  namespace
  {
    using Crc = boost::crc_optimal<64,
                                   0x42F0E1EBA9EA3693ull,
                                   0xFFFFFFFFFFFFFFFFull,
                                   0xFFFFFFFFFFFFFFFFull,
                                   true,
                                   true>;

    /** What is read of a file at once, bytes. */
    constexpr std::size_t piece_size = 1 << 22;

    std::string
    digits_of(const Crc &crc)
    {
      std::array<char, 17> digits;
      std::snprintf(digits.data(),
                    digits.size(),
                    "%016llx",
                    static_cast<unsigned long long>(crc.checksum()));
      return digits.data();
    }
  } // namespace



  std::string
  checksum_of(const char *data, const std::size_t size)
  {
    Crc crc;
    crc.process_bytes(data, size);
    return digits_of(crc);
  }



  FileChecksum
  checksum_of_file(const std::string &path, const std::size_t start)
  {
    require_input_file(path);
    std::ifstream in(path, std::ios::binary);
    in.seekg(static_cast<std::streamoff>(start));
    Crc               crc;
    std::size_t       size = 0;
    std::vector<char> piece(piece_size);
    while (in)
      {
        in.read(piece.data(), piece.size());
        crc.process_bytes(piece.data(), in.gcount());
        size += in.gcount();
      }
    if (in.bad())
      throw InputError("cannot read '" + path + "'");
    return {digits_of(crc), size};
  }

  std::string
  checksum_of(const std::string &text)
  {
    return checksum_of(text.data(), text.size());
  }



  RunningChecksum::RunningChecksum()
    : remainder(Crc().get_interim_remainder())
  {
  }

  void
  RunningChecksum::add(const char *data, const std::size_t size)
  {
    Crc crc(remainder);
    crc.process_bytes(data, size);
    remainder = crc.get_interim_remainder();
  }

  std::uint64_t
  RunningChecksum::value() const
  {
    return Crc(remainder).checksum();
  }
} // namespace squeal
