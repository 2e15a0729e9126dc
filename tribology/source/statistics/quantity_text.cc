// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/tribology/statistics/quantity_text.h>

#include <algorithm>
#include <regex>
#include <utility>

namespace squeal::tribology
{
  namespace
  {
    // The longer endings first: "_pa_m_per_s" ends in "_m_per_s" and in
    // "_per_s" as well.
    const std::pair<const char *, const char *> endings[] = {
      {"_pa_m_per_s", "Pa m/s"},
      {"_m_per_s", "m/s"},
      {"_w_per_m2", "W/m^2"},
      {"_j_per_m2", "J/m^2"},
      {"_pa_m", "Pa m"},
      {"_pa_s", "Pa s"},
      {"_per_m2", "1/m^2"},
      {"_per_s", "1/s"},
      {"_per_m", "1/m"},
      {"_deg", "deg"},
      {"_pa", "Pa"},
      {"_m2", "m^2"},
      {"_hz", "Hz"},
      {"_m", "m"},
      {"_n", "N"},
      {"_s", "s"},
      {"_w", "W"}};

    /** A ratio of damages ends in the slope, as in "_m2", not in a unit. */
    bool
    ends_in_slope(const std::string &column)
    {
      return column.rfind("dirlik_over_counting_", 0) == 0;
    }
  } // namespace



  QuantityText::QuantityText(const std::string &column)
    : name(column)
  {
    for (const auto &[ending, symbol] : endings)
      {
        const std::string end(ending);
        if (!ends_in_slope(column) && column.size() > end.size() &&
            column.compare(column.size() - end.size(), end.size(), end) == 0)
          {
            name = column.substr(0, column.size() - end.size());
            unit = symbol;
            break;
          }
      }
    name = std::regex_replace(
      name, std::regex("_m([0-9]+(\\.[0-9]+)?)(?=_|$)"), " (slope $1)");
    std::replace(name.begin(), name.end(), '_', ' ');
  }



  std::string
  QuantityText::with_unit() const
  {
    return unit.empty() ? name : name + " in " + unit;
  }
} // namespace squeal::tribology
