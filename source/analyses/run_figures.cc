// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/analyses/run_figures.h>

#include <cmath>

namespace squeal
{
  double
  RunFigure::relative(const double difference, const double of_value) const
  {
    return std::abs(difference) /
           (std::isfinite(scale) ? scale : std::abs(of_value));
  }

  bool
  RunFigures::is_solved() const
  {
    return !figures.empty();
  }

  double
  RunFigures::value_of(const std::string &name) const
  {
    for (const RunFigure &figure : figures)
      if (figure.name == name)
        return figure.value;
    return std::nan("not there");
  }
} // namespace squeal
