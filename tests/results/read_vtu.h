// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tests_read_vtu_h
#define squeal_tests_read_vtu_h

#include <squeal/base/files.h>

#include <zlib.h>

#include "check.h"

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace squeal
{
  namespace testing
  {
    /** Checks that every tag is closed in order and that text holds no stray
     * markup; attributes must be name="value". */
    inline void
    check_xml(const std::string &xml, const std::string &name)
    {
      std::vector<std::string> open;
      bool                     ok      = xml.compare(0, 6, "<?xml ") == 0;
      unsigned int             n_roots = 0;
      for (std::size_t i = xml.find("?>") + 2; ok && i < xml.size();)
        {
          const std::size_t begin = xml.find('<', i);
          ok =
            xml.find('>', i) >= begin && xml.find_first_of("&\"", i) >= begin;
          if (begin == std::string::npos)
            break;
          const std::size_t end = xml.find('>', begin);
          ok                    = ok && end != std::string::npos;
          if (!ok)
            break;
          std::string tag = xml.substr(begin + 1, end - begin - 1);
          i               = end + 1;
          if (tag[0] == '/')
            {
              ok = !open.empty() && tag == "/" + open.back();
              if (ok)
                open.pop_back();
              continue;
            }
          const bool closed = tag.back() == '/';
          if (closed)
            tag.pop_back();
          std::size_t n_quotes = 0, n_equals = 0;
          for (const char c : tag)
            {
              n_quotes += c == '"';
              n_equals += c == '=' && n_quotes % 2 == 0;
              ok = ok && c != '<';
            }
          ok = ok && n_quotes == 2 * n_equals;
          n_roots += open.empty();
          if (!closed)
            open.push_back(tag.substr(0, tag.find(' ')));
        }
      check(ok && open.empty() && n_roots == 1, name + " is well-formed XML");
    }



    inline std::vector<unsigned char>
    from_base64(const std::string &text)
    {
      const std::string letters =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
      std::vector<unsigned char> bytes;
      std::uint32_t              bits = 0, n_bits = 0;
      for (const char c : text)
        {
          if (c == '=')
            break;
          const auto value = letters.find(c);
          if (value == std::string::npos)
            check(false, "base64 text");
          bits = bits << 6 | value;
          n_bits += 6;
          if (n_bits >= 8)
            {
              n_bits -= 8;
              bytes.push_back(bits >> n_bits & 255);
            }
        }
      return bytes;
    }



    /** The values of the first array called @p name in a VTU's text. */
    template <typename T>
    std::vector<T>
    vtu_array(const std::string &xml, const std::string &name)
    {
      const std::size_t at = xml.find(" Name=\"" + name + "\"");
      if (at == std::string::npos)
        check(false, "there is an array " + name);
      const std::size_t begin = xml.find('>', at) + 2;
      const std::string text = xml.substr(begin, xml.find('\n', begin) - begin);
      // number of blocks, block size, last partial block, compressed sizes
      std::uint32_t n_blocks;
      const auto    first = from_base64(text.substr(0, 8));
      std::memcpy(&n_blocks, first.data(), 4);
      const std::size_t n_head     = (4 * (3 + n_blocks) + 2) / 3 * 4;
      const auto        head_bytes = from_base64(text.substr(0, n_head));
      std::vector<std::uint32_t> head(3 + n_blocks);
      std::memcpy(head.data(), head_bytes.data(), 4 * head.size());
      const auto  bytes = from_base64(text.substr(n_head));
      std::string raw;
      std::size_t position = 0;
      for (unsigned int b = 0; b < n_blocks; ++b)
        {
          const bool  last = b + 1 == n_blocks && head[2] != 0;
          std::string block(last ? head[2] : head[1], '\0');
          uLongf      n = block.size();
          if (uncompress(reinterpret_cast<unsigned char *>(&block[0]),
                         &n,
                         bytes.data() + position,
                         head[3 + b]) != Z_OK ||
              n != block.size())
            check(false, "the array " + name + " is whole");
          position += head[3 + b];
          raw += block;
        }
      check(position == bytes.size(), "the array " + name + " ends in time");
      std::vector<T> values(raw.size() / sizeof(T));
      std::memcpy(values.data(), raw.data(), raw.size());
      return values;
    }



    /** A number of the field data. */
    inline double
    vtu_number(const std::string &xml, const std::string &name)
    {
      const std::size_t at = xml.find(" Name=\"" + name + "\"");
      if (at == std::string::npos)
        check(false, "there is a number " + name);
      return std::stod(xml.substr(xml.find('>', at) + 1));
    }
  } // namespace testing
} // namespace squeal

#endif
