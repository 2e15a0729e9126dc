// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/eigen/mode_naming_profile.h>

#include <cmath>
#include <complex>

namespace squeal
{
  Eigen::VectorXd
  most_real_part(const Eigen::VectorXcd &profile)
  {
    // The squared norm of the real part after turning by phi is
    // (|p|^2 + Re(exp(2 i phi) sum p^2)) / 2.
    const std::complex<double> sum   = profile.cwiseProduct(profile).sum();
    const std::complex<double> phase = std::polar(1., -0.5 * std::arg(sum));
    return (phase * profile).real();
  }



  unsigned int
  n_sign_changes(const Eigen::VectorXd &profile, const double threshold)
  {
    if (profile.size() == 0)
      return 0;
    const double limit    = threshold * profile.cwiseAbs().maxCoeff();
    double       previous = 0.;
    unsigned int changes  = 0;
    for (const double value : profile)
      if (std::abs(value) > limit)
        {
          if (previous * value < 0.)
            ++changes;
          previous = value;
        }
    return changes;
  }
} // namespace squeal
