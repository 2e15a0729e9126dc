// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_base_worst_of_h
#define squeal_base_worst_of_h

#include <Eigen/Core>

#include <cmath>

namespace squeal
{
  /** The larger of two errors; NaN where one of them is NaN, which std::max
   * drops when it comes second. */
  inline double
  worst_of(const double a, const double b)
  {
    return std::isnan(a) || a >= b ? a : b;
  }

  /** Whether @p value takes the place of @p worst: it is larger or NaN, and
   * nothing takes the place of NaN. */
  inline bool
  is_worse(const double value, const double worst)
  {
    return !std::isnan(worst) && !(value <= worst);
  }

  /** The largest coefficient of errors; NaN where one of them is NaN, which
   * maxCoeff() may drop, and 0 where there is none. */
  template <typename Derived>
  double
  worst_of(const Eigen::DenseBase<Derived> &errors)
  {
    return errors.size() == 0
             ? 0.
             : errors.derived().template maxCoeff<Eigen::PropagateNaN>();
  }
} // namespace squeal

#endif
