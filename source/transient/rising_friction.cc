// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/transient/rising_friction.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace squeal
{
  namespace
  {
    /** Bisection alone, where a table has points, ends within this. */
    constexpr unsigned int slip_iterations = 100;
    constexpr double slip_digits = 4. * std::numeric_limits<double>::epsilon();
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
    double low = 0., high = tried / stiffness, s = 0.;
    for (unsigned int i = 0;
         i < slip_iterations && high - low > slip_digits * high;
         ++i)
      {
        const double missing        = excess(s);
        (missing > 0. ? high : low) = s;
        if (std::abs(missing) <= slip_digits * tried)
          break;
        s -= missing / (stiffness + slope(s / duration) / duration * normal);
        if (!(s > low && s < high))
          s = 0.5 * (low + high);
      }
    return Slip{coefficient(s / duration), slope(s / duration) / duration};
  }
} // namespace squeal
