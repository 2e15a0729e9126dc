// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_parameters_numbers_h
#define squeal_parameters_numbers_h

#include <optional>
#include <string>

namespace squeal
{
  namespace prm
  {
    /**
     * The number written in @p text: decimal ("2.5e10", "-3", ".5") or a power
     * of a positive decimal ("10^10.4", "-10^3" = -(10^3)). Nothing if the
     * text is anything else, not finite ("nan", "inf") or out of the range of
     * double. Independent of the locale.
     */
    std::optional<double> parse_number(const std::string &text);

    /** The shortest text that parse_number() turns into the same number. */
    std::string format_number(double number);
  } // namespace prm
} // namespace squeal

#endif
