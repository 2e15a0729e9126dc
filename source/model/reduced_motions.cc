// SPDX-License-Identifier: LGPL-2.1-or-later

// Motions of the reduced model about steady sliding: which of them grow, which
// a run has, and what the damping at the cut-off does to them.

#include <squeal/base/exceptions.h>
#include <squeal/base/number_text.h>
#include <squeal/base/run_log.h>
#include <squeal/eigen/dense_quadratic.h>
#include <squeal/model/reduced_motions.h>

#include <algorithm>
#include <cmath>

namespace squeal
{
  LinearizedMotion
  motions_about(const SteadyModel &about)
  {
    const PressedModel &pressed = about.pressed;
    if (pressed.model().n_modes() == 0)
      throw InputError(
        "Transient/Cut-off: no mode of the bodies lies below it, "
        "so nothing can vibrate; raise it");
    return linearize(pressed.model(),
                     about.sliding,
                     pressed.sliding_friction(),
                     pressed.speed());
  }

  std::vector<Eigen::Index>
  pairs_in_band(const LinearizedMotion &linear, const EigenParameters &band)
  {
    std::vector<Eigen::Index> result;
    for (Eigen::Index k = 0; k < linear.lambda.size(); ++k)
      if (is_between(linear.lambda[k].imag() / (2. * M_PI),
                     band.lowest_frequency,
                     band.highest_frequency))
        result.push_back(k);
    std::sort(result.begin(),
              result.end(),
              [&](const Eigen::Index a, const Eigen::Index b) {
                return linear.lambda[a].real() > linear.lambda[b].real();
              });
    return result;
  }

  std::vector<Eigen::Index>
  growing_pairs(const LinearizedMotion &linear, const EigenParameters &band)
  {
    std::vector<Eigen::Index> result = pairs_in_band(linear, band);
    result.erase(std::find_if(result.begin(),
                              result.end(),
                              [&](const Eigen::Index k) {
                                return !(linear.lambda[k].real() > 0.);
                              }),
                 result.end());
    return result;
  }



  bool
  is_of_the_run(const std::complex<double> lambda, const TransientParameters &t)
  {
    return t.integrator == TransientParameters::Integrator::reduced ||
           std::abs(lambda.imag()) <= 2. * M_PI * t.cut_off;
  }

  std::complex<double>
  fastest_growth(const LinearizedMotion &linear, const TransientParameters &t)
  {
    Eigen::Index k = -1;
    for (Eigen::Index i = 0; i < linear.lambda.size(); ++i)
      if (is_of_the_run(linear.lambda[i], t) &&
          (k < 0 || linear.lambda[i].real() > linear.lambda[k].real()))
        k = i;
    // Below is rounding.
    return k >= 0 && linear.lambda[k].real() > 1e-9 * std::abs(linear.lambda[k])
             ? linear.lambda[k]
             : 0.;
  }



  void
  report_cut_off_damping(const PressedModel              &pressed,
                         const SteadySliding             &steady,
                         const LinearizedMotion          &linear,
                         const std::vector<Eigen::Index> &pairs,
                         const Parameters                &p,
                         RunLog                          &log)
  {
    const double ratio = p.transient.cut_off_damping;
    if (ratio == 0. || pairs.empty())
      return;
    ReducedContactModel undamped = pressed.model();
    add_cut_off_damping(undamped, -ratio);
    const LinearizedMotion without =
      linearize(undamped, steady, pressed.sliding_friction(), pressed.speed());
    for (const Eigen::Index k : pairs)
      {
        const std::complex<double> lambda = linear.lambda[k];
        Eigen::Index               nearest;
        (without.lambda.array() - lambda).abs().minCoeff(&nearest);
        const std::complex<double> shift = lambda - without.lambda[nearest];
        const std::string          text =
          "damping at the cut-off shifts the pair at " +
          rounded_text(lambda.imag() / (2. * M_PI), 6) + " Hz by " +
          rounded_text(shift.real(), 3) + " 1/s and " +
          rounded_text(shift.imag() / (2. * M_PI), 3) + " Hz";
        log.info("  " + text);
        if (std::abs(shift.real()) >
            std::max(3., .02 * std::abs(lambda.real())))
          log.warning(text + ": lower it or raise the cut-off");
      }
  }
} // namespace squeal
