// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/transient/lag_limit.h>

#include <algorithm>
#include <cmath>

namespace squeal
{
  namespace
  {
    /** Towards a largest eigenvalue of which two digits are enough. */
    constexpr unsigned int lag_iterations = 50;
  } // namespace



  LagLimit
  lag_limit(const ReducedContactModel &model,
            const SteadySliding       &steady,
            const Eigen::VectorXd     &fall,
            const double               step)
  {
    LagLimit              result;
    const unsigned int    n       = model.n_nodes();
    const auto            along   = Eigen::seqN(1, n, 3);
    const Eigen::MatrixXd G       = model.flexibility(along, along);
    Eigen::VectorXd       weights = Eigen::VectorXd::Zero(n);
    for (unsigned int j = 0; j < n; ++j)
      if (steady.status[j] == ContactStatus::slip)
        {
          weights[j] = std::sqrt(std::max(0., steady.forces[3 * j] * fall[j]));
          if (weights[j] * weights[j] * G(j, j) > step)
            ++result.n_above;
        }
    // The matrix is positive semidefinite, and its largest eigenvalue is
    // approached from below.
    Eigen::VectorXd x = weights;
    for (unsigned int i = 0; i < lag_iterations && x.norm() > 0.; ++i)
      {
        x.normalize();
        x               = weights.cwiseProduct(G * weights.cwiseProduct(x));
        result.shortest = x.norm();
      }
    return result;
  }
} // namespace squeal
