// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/output/headline_error.h>

#include <cmath>
#include <limits>

namespace squeal
{
  std::string
  headline_error(const std::vector<ErrorSource> &sources,
                 const std::string              &unit)
  {
    const ErrorSource *largest = nullptr;
    std::string        unknown;
    for (const ErrorSource &source : sources)
      if (std::isnan(source.second))
        unknown +=
          (unknown.empty() ? "" : "; ") + source.first + " error not estimated";
      else if (!largest || source.second > largest->second)
        largest = &source;
    if (!largest)
      return unknown;
    // Relative errors that a person would say in per cent.
    const bool per_cent = unit.empty() && largest->second >= 1e-4;
    return rounded_text((per_cent ? 100. : 1.) * largest->second, 2) +
           (per_cent ? " %" : unit) + " (" + largest->first + ")" +
           (unknown.empty() ? "" : "; " + unknown);
  }



  ErrorSource
  error_of_column(const std::string &name,
                  const Table       &table,
                  const std::string &column)
  {
    ErrorSource source{name, std::numeric_limits<double>::quiet_NaN()};
    std::size_t n = 0;
    if (table.has_column(column))
      for (std::size_t i = 0; i < table.n_rows(); ++i)
        {
          const double value =
            table.is_missing(i, column) ? 0. : std::abs(table.real(i, column));
          if (table.is_missing(i, column) || std::isnan(value))
            continue;
          ++n;
          if (!(value <= source.second))
            source.second = value;
        }
    if (n > 0 && n < table.n_rows())
      source.first += ", known for " + std::to_string(n) + " of " +
                      std::to_string(table.n_rows());
    return source;
  }
} // namespace squeal
