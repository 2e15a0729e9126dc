// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/tribology/fatigue/accumulation.h>

#include <cmath>
#include <limits>

namespace squeal::tribology
{
  MansonHalford::MansonHalford(const double reference_life)
    : reference_life(reference_life)
    , logarithm(-std::numeric_limits<double>::infinity())
  {
  }



  double
  MansonHalford::used(const double life) const
  {
    return std::exp(logarithm * std::pow(reference_life / life, 0.4));
  }



  void
  MansonHalford::add(const double n, const double life)
  {
    if (n == 0. || std::isinf(life))
      return;
    logarithm =
      std::log(used(life) + n / life) * std::pow(life / reference_life, 0.4);
  }



  double
  MansonHalford::damage() const
  {
    return std::exp(logarithm);
  }



  double
  MansonHalford::rest(const double life) const
  {
    return 1. - used(life);
  }
} // namespace squeal::tribology
