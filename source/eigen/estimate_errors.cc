// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/eigen/certified_solver.h>

#include <algorithm>
#include <cmath>

namespace squeal
{
  namespace
  {
    using Complex = std::complex<double>;

    /** Number of the value in @p values nearest to @p lambda. */
    int
    nearest_but(const Eigen::VectorXcd &values,
                const Complex           lambda,
                const int               except = -1)
    {
      int    best     = -1;
      double distance = 1e300;
      for (Eigen::Index i = 0; i < values.size(); ++i)
        if (const double d = std::abs(values[i] - lambda);
            d < distance && i != except)
          {
            distance = d;
            best     = i;
          }
      return best;
    }
  } // namespace



  void
  estimate_errors(ComplexPairs &pairs, const Eigen::VectorXcd &better)
  {
    const unsigned int n = pairs.size();
    pairs.error_estimate.resize(n);
    pairs.pair_partner.assign(n, -1);
    for (unsigned int i = 0; i < n; ++i)
      {
        const Complex a = pairs.lambda[i];
        const int     k = nearest_but(better, a);
        // Of a nearly defective pair mean and squared half-difference count;
        // the other member may lie beyond the band.
        const int j = nearest_but(pairs.lambda, a, i);
        const int l = j < 0 ? -1 : nearest_but(better, pairs.lambda[j], k);
        if (pairs.condition[i] < coalescence_condition || l < 0)
          {
            pairs.error_estimate[i] = std::abs(better[k] - a) / std::abs(a);
            continue;
          }
        const Complex b      = pairs.lambda[j];
        const Complex mean   = 0.5 * (a + b),
                      mean_2 = 0.5 * (better[k] + better[l]);
        const Complex d2     = 0.25 * (a - b) * (a - b);
        const Complex d2_2 =
          0.25 * (better[k] - better[l]) * (better[k] - better[l]);
        pairs.pair_partner[i] = j;
        pairs.error_estimate[i] =
          (std::abs(mean - mean_2) +
           std::abs(d2 - d2_2) /
             std::max(std::sqrt(std::abs(d2 - d2_2)),
                      std::sqrt(std::abs(d2)) + std::sqrt(std::abs(d2_2)))) /
          std::abs(a);
        if (d2 == d2_2)
          pairs.error_estimate[i] = std::abs(mean - mean_2) / std::abs(a);
      }
  }
} // namespace squeal
