// SPDX-License-Identifier: LGPL-2.1-or-later

// Motions of the reduced model that grow outside the band, and which of them a
// run has.

#include <squeal/analyses/transient/transient_results.h>

#include <cmath>

namespace squeal
{
  bool
  is_of_the_run(const std::complex<double> lambda, const TransientParameters &t)
  {
    return t.integrator == TransientParameters::Integrator::reduced ||
           std::abs(lambda.imag()) <= 2. * M_PI * t.cut_off;
  }

  std::string
  text_of_growth_outside(const LinearizedMotion &linear, const Parameters &p)
  {
    Eigen::Index k = -1;
    for (Eigen::Index i = 0; i < linear.lambda.size(); ++i)
      if (is_of_the_run(linear.lambda[i], p.transient) &&
          (k < 0 || linear.lambda[i].real() > linear.lambda[k].real()))
        k = i;
    if (k < 0)
      return "";
    const double sigma     = linear.lambda[k].real(),
                 frequency = linear.lambda[k].imag() / (2. * M_PI);
    // Below is rounding.
    if (!(sigma > 1e-9 * std::abs(linear.lambda[k])) ||
        (frequency >= p.eigen.lowest_frequency &&
         frequency <= p.eigen.highest_frequency))
      return "";
    return "a motion at " + rounded_text(frequency, 5) +
           " Hz, outside the band, grows (sigma of " + rounded_text(sigma, 3) +
           " 1/s)";
  }
} // namespace squeal
