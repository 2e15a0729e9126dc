// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/results/column_title.h>

#include <algorithm>
#include <set>

namespace squeal
{
  ColumnTitle::ColumnTitle(const Table::Column &column)
    : name(column.name)
    , unit(column.unit)
  {
    static const std::set<std::string> unit_words = {"hz",
                                                     "deg",
                                                     "s",
                                                     "per",
                                                     "rel",
                                                     "mb",
                                                     "mm",
                                                     "m",
                                                     "m3",
                                                     "kg",
                                                     "n",
                                                     "pa",
                                                     "mpa"};
    const auto                         last_word  = [&]() {
      const std::size_t cut = name.rfind('_');
      return cut == std::string::npos ? "" : name.substr(cut + 1);
    };
    if (unit.empty() && last_word() == "rel")
      unit = "relative";
    while (!unit.empty() && unit_words.count(last_word()) > 0)
      name.erase(name.rfind('_'));
    std::replace(name.begin(), name.end(), '_', ' ');
  }



  std::string
  ColumnTitle::of_axis() const
  {
    return name + (unit.empty() ? "" : " in " + unit);
  }



  std::string
  ColumnTitle::with(const double value) const
  {
    // Through a number: 4 digits without zeros at the end.
    return name + " " + shortest_text(std::stod(rounded_text(value, 4))) +
           (unit.empty() ? "" : " " + unit);
  }
} // namespace squeal
