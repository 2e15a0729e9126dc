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
  typical_kappa(const Eigen::MatrixXd &K, const Eigen::MatrixXd &M)
  {
    std::vector<double> quotients;
    for (Eigen::Index i = 0; i < K.rows(); ++i)
      if (const double q = K(i, i) / M(i, i); q > 0. && std::isfinite(q))
        quotients.push_back(q);
    if (quotients.empty())
      return 1.;
    const auto low = quotients.begin() + quotients.size() / 20;
    std::nth_element(quotients.begin(), low, quotients.end());
    return *low;
  }
} // namespace squeal
