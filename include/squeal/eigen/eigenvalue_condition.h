// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_eigen_eigenvalue_condition_h
#define squeal_eigen_eigenvalue_condition_h

#include <algorithm>
#include <complex>
#include <limits>

namespace squeal
{
  /** Condition of an eigenvalue (ComplexPairs::condition) from @p size,
   * ||x|| ||y|| in mass norms, and @p product, y^T (2 lambda M + C) x. At a
   * coalescence, where the product is zero but for rounding, it is the most
   * that double precision tells apart: 4.5e15. */
  inline double
  eigenvalue_condition(const std::complex<double> lambda,
                       const double               size,
                       const std::complex<double> product)
  {
    const double largest = 2. * std::abs(lambda) * size;
    return largest / std::max({std::abs(product),
                               std::numeric_limits<double>::epsilon() * largest,
                               1e-300});
  }
} // namespace squeal

#endif
