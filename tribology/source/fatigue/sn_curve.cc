// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/tribology/fatigue/sn_curve.h>
#include <squeal/tribology/setup/damage_parameters.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>

namespace squeal::tribology
{
  namespace
  {
    constexpr std::size_t block = 512;

    /** result *= x^exponent by squaring, for all x at once; x is lost. */
    void
    multiply_by_whole_power(double *const     x,
                            const std::size_t n,
                            unsigned int      exponent,
                            double *const     result)
    {
      for (; exponent > 0; exponent /= 2)
        {
          if (exponent % 2 == 1)
            for (std::size_t i = 0; i < n; ++i)
              result[i] *= x[i];
          for (std::size_t i = 0; i < n; ++i)
            x[i] *= x[i];
        }
    }
  } // namespace



  void
  SnCurve::damage(const double *amplitudes,
                  std::size_t   n,
                  double       *damages) const
  {
    for (; n > block; n -= block, amplitudes += block, damages += block)
      damage_of_block(amplitudes, block, damages);
    damage_of_block(amplitudes, n, damages);
  }



  void
  SnCurve::damage_of_block(const double *const amplitudes,
                           const std::size_t   n,
                           double *const       damages) const
  {
    std::array<double, block> ratio;
    for (std::size_t i = 0; i < n; ++i)
      ratio[i] = amplitudes[i] / reference_stress;
    if (std::floor(exponent) == exponent && exponent <= 64.)
      {
        std::fill(damages, damages + n, 1. / constant);
        multiply_by_whole_power(
          ratio.data(), n, static_cast<unsigned int>(exponent), damages);
      }
    else
      Eigen::Map<Eigen::ArrayXd>(damages, n) =
        Eigen::Map<const Eigen::ArrayXd>(ratio.data(), n).pow(exponent) /
        constant;
    if (knee_stress > 0.)
      {
        const double at_knee =
          std::pow(knee_stress / reference_stress, exponent) / constant;
        for (std::size_t i = 0; i < n; ++i)
          if (amplitudes[i] < knee_stress)
            damages[i] =
              at_knee * std::pow(amplitudes[i] / knee_stress, second_exponent);
      }
    if (endurance_limit > 0.)
      for (std::size_t i = 0; i < n; ++i)
        if (amplitudes[i] <= endurance_limit)
          damages[i] = 0.;
  }



  double
  SnCurve::damage(const double amplitude) const
  {
    double result;
    damage(&amplitude, 1, &result);
    return result;
  }



  double
  SnCurve::life(const double amplitude) const
  {
    return 1. / damage(amplitude);
  }



  std::vector<SnCurve>
  sn_curves(const FatigueParameters &f)
  {
    std::vector<SnCurve> curves(f.exponents.size());
    for (std::size_t i = 0; i < curves.size(); ++i)
      {
        SnCurve &c         = curves[i];
        c.exponent         = f.exponents[i];
        c.constant         = f.constants.empty() ? 1. : f.constants[i];
        c.reference_stress = f.reference_stress;
        if (f.model == FatigueParameters::Model::bilinear)
          {
            c.knee_stress     = f.knee_stress;
            c.second_exponent = f.second_exponent;
          }
        c.endurance_limit = f.endurance_limit;
      }
    return curves;
  }
} // namespace squeal::tribology
