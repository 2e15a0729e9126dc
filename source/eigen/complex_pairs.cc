// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/eigen/complex_pairs.h>
#include <squeal/eigen/unstable_pair.h>

#include <cmath>

namespace squeal
{
  double
  ComplexPairs::frequency(const unsigned int i) const
  {
    return lambda[i].imag() / (2. * M_PI);
  }

  double
  ComplexPairs::damping_ratio(const unsigned int i) const
  {
    return lambda[i] == 0. ? 0. : -lambda[i].real() / std::abs(lambda[i]);
  }



  ComplexPairs
  select_pairs(const ComplexPairs &pairs, const std::vector<int> &kept)
  {
    const Eigen::Index n = kept.size();
    ComplexPairs       result;
    result.lambda.resize(n);
    result.residual.resize(n);
    result.left_residual.resize(n);
    result.error_estimate.resize(n);
    result.condition.resize(n);
    result.noise_floor.resize(n);
    result.right.resize(pairs.right.rows(), n);
    result.left.resize(pairs.left.rows(), n);
    std::vector<int> new_number(pairs.size(), -1);
    for (Eigen::Index k = 0; k < n; ++k)
      new_number[kept[k]] = k;
    for (Eigen::Index k = 0; k < n; ++k)
      {
        const int i              = kept[k];
        result.lambda[k]         = pairs.lambda[i];
        result.residual[k]       = pairs.residual[i];
        result.left_residual[k]  = pairs.left_residual[i];
        result.error_estimate[k] = pairs.error_estimate[i];
        result.condition[k]      = pairs.condition[i];
        result.noise_floor[k]    = pairs.noise_floor[i];
        result.right.col(k)      = pairs.right.col(i);
        result.left.col(k)       = pairs.left.col(i);
        const int partner        = pairs.pair_partner[i];
        result.pair_partner.push_back(partner < 0 ? -1 : new_number[partner]);
      }
    return result;
  }



  Eigen::VectorXd
  relative_residuals(const Pencil           &pencil,
                     const Eigen::VectorXcd &lambda,
                     const Pencil::Products &products,
                     ComplexBlock           &R,
                     Eigen::VectorXd        &denominators)
  {
    R = products.stiffness;
    for (Eigen::Index j = 0; j < lambda.size(); ++j)
      R.col(j) += lambda[j] * lambda[j] * products.mass.col(j) +
                  lambda[j] * products.damping.col(j);
    const RowSpace &space = *pencil.space();
    denominators =
      lambda.cwiseAbs2().array() * space.norms(products.mass).array() +
      lambda.cwiseAbs().array() * space.norms(products.damping).array() +
      space.norms(products.stiffness).array();
    return space.norms(R).array() / denominators.array().max(1e-300);
  }



  double
  sigma_error(const ComplexPairs &pairs, const unsigned int i)
  {
    // Where no error is estimated, as by the direct solver, the residual is
    // one, times the condition; where that is not known it may be a
    // coalescence, which moves by the root.
    const double estimate = std::isnan(pairs.error_estimate[i])
                              ? (std::isnan(pairs.condition[i])
                                   ? std::sqrt(pairs.residual[i])
                                   : pairs.residual[i] * pairs.condition[i])
                              : pairs.error_estimate[i],
                 floor    = pairs.noise_floor[i];
    return (estimate > floor ? estimate : floor) * std::abs(pairs.lambda[i]);
  }

  bool
  is_unstable(const ComplexPairs &pairs, const unsigned int i)
  {
    return pairs.sigma(i) > sigma_error(pairs, i);
  }
} // namespace squeal
