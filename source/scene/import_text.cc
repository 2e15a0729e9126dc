// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/inputs_read.h>

#include <squeal/parameters/text.h>

#include <squeal/scene/import_text.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <limits>

namespace squeal
{
  namespace import
  {
    namespace
    {
      bool
      is_blank(const char c)
      {
        return c == ' ' || c == '\t';
      }

      bool
      is_text(const std::string &content)
      {
        // The first few kilobytes tell; a text file has no control characters
        // but tabs, line ends and form feeds.
        const std::size_t n = std::min<std::size_t>(content.size(), 65536);
        return std::none_of(content.begin(), content.begin() + n, [](char c) {
          return static_cast<unsigned char>(c) < 32 && c != '\t' && c != '\n' &&
                 c != '\r' && c != '\f';
        });
      }

      /** Reads the whole text; "inf" and "nan" included. */
      bool
      parse_c_real(const std::string_view text, double &value)
      {
        const char *const begin = text.data(), *const end = begin + text.size();
        const auto result = std::from_chars(begin, end, value);
        if (result.ptr != end)
          return false;
        if (result.ec == std::errc::result_out_of_range)
          value = text.find("e-") == std::string_view::npos &&
                      text.find("E-") == std::string_view::npos
                    ? std::numeric_limits<double>::infinity()
                    : 0.;
        return result.ec != std::errc::invalid_argument;
      }

      /** Turns 1.0D+5, 3.+5 and -2.5-3 into C notation. */
      std::string
      with_c_exponent(const std::string_view text)
      {
        std::string result(text);
        for (char &c : result)
          if (c == 'd' || c == 'D')
            c = 'e';
        const std::size_t sign = result.find_last_of("+-");
        if (sign != std::string::npos && sign > 0 &&
            (std::isdigit(static_cast<unsigned char>(result[sign - 1])) ||
             result[sign - 1] == '.'))
          result.insert(sign, "e");
        return result;
      }
    } // namespace



    TextFile::TextFile(const std::string &name)
      : file_name(name)
      , content(read_input_file(name))
    {
      if (content.find_first_not_of(" \t\r\n\f") == std::string::npos)
        throw InputError(file_name + " is empty");
      if (!is_text(content))
        throw InputError(file_name + " is not a text file");
      rewind();
    }



    bool
    TextFile::next()
    {
      if (position >= content.size())
        return false;
      std::size_t end = content.find('\n', position);
      if (end == std::string::npos)
        end = content.size();
      current  = std::string_view(content).substr(position, end - position);
      position = end + 1;
      while (!current.empty() &&
             (current.back() == '\r' || current.back() == '\f'))
        current.remove_suffix(1);
      ++number;
      return true;
    }



    std::string_view
    TextFile::line() const
    {
      return current;
    }



    unsigned int
    TextFile::line_number() const
    {
      return number;
    }



    void
    TextFile::rewind()
    {
      const std::string_view byte_order_mark = "\xef\xbb\xbf";
      position =
        std::string_view(content).substr(0, 3) == byte_order_mark ? 3 : 0;
      number  = 0;
      current = {};
    }



    void
    TextFile::check_last_line_is_complete() const
    {
      if (content.back() != '\n')
        throw InputError(file_name +
                         ": its last line has no line end: the file is "
                         "truncated (or add the line end)");
    }



    void
    TextFile::fail(const std::string &text) const
    {
      fail_at(number, text);
    }



    void
    TextFile::fail_at(const unsigned int number, const std::string &text) const
    {
      throw InputError(file_name + ":" + std::to_string(number) + ": " + text);
    }



    const std::string &
    TextFile::name() const
    {
      return file_name;
    }



    Fields
    split_at_blanks_and_commas(const std::string_view line)
    {
      const auto separates = [](const char c) {
        return is_blank(c) || c == ',';
      };
      Fields      fields;
      std::size_t i = 0;
      while (true)
        {
          while (i < line.size() && separates(line[i]))
            ++i;
          if (i == line.size())
            return fields;
          const std::size_t begin = i;
          while (i < line.size() && !separates(line[i]))
            ++i;
          if (fields.n < fields.field.size())
            fields.field[fields.n] = line.substr(begin, i - begin);
          ++fields.n;
        }
    }



    std::string_view
    trimmed(std::string_view text)
    {
      while (!text.empty() && is_blank(text.front()))
        text.remove_prefix(1);
      while (!text.empty() && is_blank(text.back()))
        text.remove_suffix(1);
      return text;
    }



    std::string
    upper_case(const std::string_view text)
    {
      std::string result(text);
      std::transform(result.begin(), result.end(), result.begin(), [](char c) {
        return static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
      });
      return result;
    }



    bool
    parse_integer(std::string_view text, long &value)
    {
      if (text.size() > 1 && text[0] == '+' && text[1] != '-')
        text.remove_prefix(1);
      const char *const begin = text.data(), *const end = begin + text.size();
      const auto result = std::from_chars(begin, end, value);
      return result.ec == std::errc() && result.ptr == end;
    }



    bool
    parse_real(std::string_view text, double &value)
    {
      if (text.size() > 1 && text[0] == '+' && text[1] != '-')
        text.remove_prefix(1);
      return parse_c_real(text, value) ||
             parse_c_real(with_c_exponent(text), value);
    }



    long
    integer_field(const TextFile        &file,
                  const std::string_view text,
                  const char            *what)
    {
      long value = 0;
      if (!parse_integer(text, value))
        file.fail(std::string(what) + " " + prm::in_quotes(std::string(text)) +
                  " is not an integer");
      return value;
    }



    double
    real_field(const TextFile        &file,
               const std::string_view text,
               const char            *what)
    {
      double value = 0.;
      if (!parse_real(text, value))
        file.fail(std::string(what) + " " + prm::in_quotes(std::string(text)) +
                  " is not a number");
      if (!std::isfinite(value))
        file.fail(std::string(what) + " " + prm::in_quotes(std::string(text)) +
                  " is not finite");
      return value;
    }
  } // namespace import
} // namespace squeal
