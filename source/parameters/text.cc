// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/parameters/text.h>

namespace squeal
{
  namespace prm
  {
    namespace
    {
      const char *const blanks = " \t\r\f\v";

      /** Whether @p c continues a letter of several bytes in UTF-8. */
      bool
      is_continuation(const char c)
      {
        return (static_cast<unsigned char>(c) & 0xc0) == 0x80;
      }
    }



    std::string
    trim(const std::string &text)
    {
      const std::size_t first = text.find_first_not_of(blanks);
      if (first == std::string::npos)
        return "";
      return text.substr(first, text.find_last_not_of(blanks) - first + 1);
    }



    std::string
    collapse_blanks(const std::string &text)
    {
      std::string result;
      for (const char c : trim(text))
        {
          const bool blank = std::string(blanks).find(c) != std::string::npos;
          if (!blank)
            result += c;
          else if (result.back() != ' ')
            result += ' ';
        }
      return result;
    }



    std::vector<std::string>
    split(const std::string &text, const char separator)
    {
      std::vector<std::string> parts;
      if (trim(text).empty())
        return parts;
      std::size_t start = 0;
      while (true)
        {
          const std::size_t end = text.find(separator, start);
          parts.push_back(trim(text.substr(start, end - start)));
          if (end == std::string::npos)
            return parts;
          start = end + 1;
        }
    }



    std::string
    join(const std::vector<std::string> &parts, const std::string &separator)
    {
      std::string result;
      for (std::size_t i = 0; i < parts.size(); ++i)
        result += (i == 0 ? "" : separator) + parts[i];
      return result;
    }



    bool
    is_utf8(const std::string &text)
    {
      for (std::size_t i = 0; i < text.size();)
        {
          const unsigned char lead        = static_cast<unsigned char>(text[i]);
          std::size_t         n_following = 0;
          if (lead >= 0xf0 && lead <= 0xf4)
            n_following = 3;
          else if (lead >= 0xe0 && lead < 0xf0)
            n_following = 2;
          else if (lead >= 0xc2 && lead < 0xe0)
            n_following = 1;
          else if (lead >= 0x80)
            return false;
          if (i + n_following >= text.size())
            return false;
          for (std::size_t k = 1; k <= n_following; ++k)
            if (!is_continuation(text[i + k]))
              return false;
          // overlong forms, surrogates and what lies beyond Unicode
          const unsigned char second =
            n_following == 0 ? 0 : static_cast<unsigned char>(text[i + 1]);
          if ((lead == 0xe0 && second < 0xa0) ||
              (lead == 0xed && second > 0x9f) ||
              (lead == 0xf0 && second < 0x90) ||
              (lead == 0xf4 && second > 0x8f))
            return false;
          i += n_following + 1;
        }
      return true;
    }



    std::string
    in_quotes(const std::string &text)
    {
      std::size_t length = text.size();
      if (length > 200)
        for (length = 200; length > 0 && is_continuation(text[length]);)
          --length;
      std::string result = "'";
      for (const char c : text.substr(0, length))
        {
          const unsigned char code = static_cast<unsigned char>(c);
          result += code < 0x20 || code == 0x7f ? '?' : c;
        }
      return result + (text.size() > length ? "...'" : "'");
    }



    bool
    starts_with(const std::string &text, const std::string &start)
    {
      return text.compare(0, start.size(), start) == 0;
    }



    std::string
    section_of(const std::string &path)
    {
      const std::size_t slash = path.rfind('/');
      return slash == std::string::npos ? "" : path.substr(0, slash);
    }



    std::string
    entry_of(const std::string &path)
    {
      const std::size_t slash = path.rfind('/');
      return slash == std::string::npos ? path : path.substr(slash + 1);
    }



    std::string
    path_of(const std::string &section, const std::string &entry)
    {
      return section.empty() ? entry : section + "/" + entry;
    }
  } // namespace prm
} // namespace squeal
