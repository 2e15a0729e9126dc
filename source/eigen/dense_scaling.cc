// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/eigen/dense_scaling.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace squeal
{
  Eigen::VectorXd
  unit_diagonal_scales(const Eigen::MatrixXd &A)
  {
    return A.diagonal().cwiseAbs().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  }



  double
  typical_kappa(const Eigen::MatrixXd &K,
                const Eigen::MatrixXd &M,
                const double           least)
  {
    std::vector<double> quotients;
    for (Eigen::Index i = 0; i < K.rows(); ++i)
      if (const double q = K(i, i) / M(i, i); q > 0. && std::isfinite(q))
        quotients.push_back(q);
    auto first = std::partition(quotients.begin(),
                                quotients.end(),
                                [least](const double q) { return q < least; });
    if (first == quotients.end())
      first = quotients.begin();
    const auto n = quotients.end() - first;
    if (n == 0)
      return 1.;
    std::nth_element(first, first + n / 20, quotients.end());
    return first[n / 20];
  }



  double
  least_kappa(const double highest)
  {
    // Three decades: rounding leaves free motions far below, and a pair as low
    // loses nothing by a kappa of its own size.
    return std::pow(1e-3 * highest, 2);
  }
} // namespace squeal
