// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/number_text.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace squeal
{
  std::string
  shortest_text(const double value)
  {
    char       buffer[64];
    const auto end = std::to_chars(buffer, buffer + sizeof(buffer), value).ptr;
    return std::string(buffer, end);
  }



  std::string
  rounded_text(const double value, const int n_digits)
  {
    if (!std::isfinite(value) || value == 0.)
      return shortest_text(value == 0. ? 0. : value);
    char       buffer[512];
    const auto print = [&](const std::chars_format format,
                           const int               precision) {
      const auto end = std::to_chars(
        buffer, buffer + sizeof(buffer), value, format, precision);
      return std::string(buffer, end.ptr);
    };
    const std::string scientific =
      print(std::chars_format::scientific, n_digits - 1);
    // the exponent after rounding: 999.96 has four digits before the point
    const int exponent = std::stoi(scientific.substr(scientific.find('e') + 1));
    if (exponent < -4 || exponent >= std::max(n_digits, 6))
      return scientific;
    return print(std::chars_format::fixed,
                 std::max(0, n_digits - 1 - exponent));
  }

  std::string
  counted(const std::size_t n, const std::string &word)
  {
    return std::to_string(n) + " " + word + (n == 1 ? "" : "s");
  }
} // namespace squeal
