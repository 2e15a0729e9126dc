// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/parameters/numbers.h>
#include <squeal/parameters/text.h>

#include <array>
#include <charconv>
#include <cmath>

namespace squeal
{
  namespace prm
  {
    namespace
    {
      std::optional<double>
      parse_decimal(const std::string &text)
      {
        // from_chars takes no plus sign
        const std::size_t start = !text.empty() && text[0] == '+' ? 1 : 0;
        if (text.size() == start || (start == 1 && text[1] == '-'))
          return {};
        double            number = 0.;
        const char *const first  = text.data() + start;
        const char *const last   = text.data() + text.size();
        const auto [end, error]  = std::from_chars(first, last, number);
        if (error != std::errc() || end != last || !std::isfinite(number))
          return {};
        return number;
      }
    } // namespace



    std::optional<double>
    parse_number(const std::string &text)
    {
      const std::size_t caret = text.find('^');
      if (caret == std::string::npos)
        return parse_decimal(trim(text));

      const std::optional<double> base =
        parse_decimal(trim(text.substr(0, caret)));
      const std::optional<double> exponent =
        parse_decimal(trim(text.substr(caret + 1)));
      if (!base || !exponent || *base == 0.)
        return {};
      const double power =
        std::copysign(std::pow(std::abs(*base), *exponent), *base);
      if (!std::isfinite(power) || power == 0.)
        return {};
      return power;
    }



    std::string
    format_number(const double number)
    {
      if (number == 0.) // no "-0"
        return "0";
      std::array<char, 40> buffer;
      const auto           end =
        std::to_chars(buffer.data(), buffer.data() + buffer.size(), number).ptr;
      std::string text(buffer.data(), end);
      // 2.1e+11 -> 2.1e11, 1e-08 -> 1e-8
      const std::size_t e = text.find('e');
      if (e != std::string::npos)
        {
          const std::string sign  = text[e + 1] == '-' ? "-" : "";
          const std::size_t digit = text.find_first_not_of("+-0", e + 1);
          text = text.substr(0, e + 1) + sign + text.substr(digit);
        }
      return text;
    }
  } // namespace prm
} // namespace squeal
