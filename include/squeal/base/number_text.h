// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_base_number_text_h
#define squeal_base_number_text_h

#include <cstddef>
#include <string>

namespace squeal
{
  /** Shortest decimal text that reads back as the same double. */
  std::string shortest_text(double value);

  /** @p value rounded to @p n_digits significant digits; no exponent between
   * 1e-4 and 10^max(n_digits, 6). */
  std::string rounded_text(double value, int n_digits);

  /** "1 pair", "2 pairs". */
  std::string counted(std::size_t n, const std::string &word);
} // namespace squeal

#endif
