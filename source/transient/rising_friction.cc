// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/transient/rising_friction.h>

#include <boost/math/tools/roots.hpp>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>

namespace squeal
{
  namespace
  {
    /** Bisection alone, where a table has points, ends within this. */
    constexpr std::uintmax_t slip_iterations = 100;
  } // namespace



  RisingFriction::RisingFriction(const FrictionLaw       &l,
                                 const FrictionLaw::Range r,
                                 const double             more)
    : law(&l)
    , range(r)
    , added(more)
  {
  }

  bool
  RisingFriction::follows() const
  {
    return law && range.first < range.last;
  }

  double
  RisingFriction::coefficient(const double v) const
  {
    return std::max(
      0., law->coefficient(std::clamp(v, range.first, range.last)) + added);
  }

  double
  RisingFriction::slope(const double v) const
  {
    return v >= range.first && v < range.last && coefficient(v) > 0.
             ? std::max(0., law->slope(v))
             : 0.;
  }



  std::optional<RisingFriction::Slip>
  RisingFriction::slip(const double tried,
                       const double normal,
                       const double stiffness,
                       const double duration) const
  {
    // What the slip of the step takes more than there is; it rises with it.
    const auto excess = [&](const double s) {
      return stiffness * s + coefficient(s / duration) * normal - tried;
    };
    if (excess(0.) >= 0.)
      return {};
    constexpr int  digits     = std::numeric_limits<double>::digits - 3;
    std::uintmax_t iterations = slip_iterations;
    const double   s          = boost::math::tools::newton_raphson_iterate(
      [&](const double x) {
        return std::make_pair(
          excess(x), stiffness + slope(x / duration) / duration * normal);
      },
      0.,
      0.,
      tried / stiffness,
      digits,
      iterations);
    return Slip{coefficient(s / duration), slope(s / duration) / duration};
  }
} // namespace squeal
