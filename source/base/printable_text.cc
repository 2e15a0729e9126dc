// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/printable_text.h>

#include <cstddef>

namespace squeal
{
  namespace
  {
    /** Bytes of the character of UTF-8 that begins at @p i, 0 if none does. */
    std::size_t
    length_of_character(const std::string &text, const std::size_t i)
    {
      const auto byte = [&](const std::size_t k) {
        return static_cast<unsigned char>(text[k]);
      };
      const unsigned char first = byte(i);
      if (first < 0x80)
        return 1;
      const std::size_t n = first >= 0xc2 && first < 0xe0   ? 2
                            : first >= 0xe0 && first < 0xf0 ? 3
                            : first >= 0xf0 && first < 0xf5 ? 4
                                                            : 0;
      if (n == 0 || i + n > text.size())
        return 0;
      for (std::size_t k = i + 1; k < i + n; ++k)
        if ((byte(k) & 0xc0) != 0x80)
          return 0;
      // Longer than needed, halves of pairs of UTF-16, beyond the last one.
      const unsigned char second = byte(i + 1);
      const bool          is_none =
        (first == 0xe0 && second < 0xa0) || (first == 0xed && second >= 0xa0) ||
        (first == 0xf0 && second < 0x90) || (first == 0xf4 && second >= 0x90);
      return is_none ? 0 : n;
    }
  } // namespace



  std::string
  printable_text(const std::string &text)
  {
    std::string result;
    for (std::size_t i = 0; i < text.size();)
      {
        const std::size_t n = length_of_character(text, i);
        const bool        is_control =
          n == 1 && text[i] != '\n' && text[i] != '\t' &&
          (static_cast<unsigned char>(text[i]) < ' ' || text[i] == 0x7f);
        if (n == 0 || is_control)
          result += '?';
        else
          result.append(text, i, n);
        i += n == 0 ? 1 : n;
      }
    return result;
  }
} // namespace squeal
