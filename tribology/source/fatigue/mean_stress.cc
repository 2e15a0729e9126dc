// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/unknown_choice.h>
#include <squeal/tribology/fatigue/mean_stress.h>

#include <cmath>

namespace squeal::tribology
{
  namespace
  {
    double
    constant_of(const FatigueParameters &f)
    {
      using Kind = MeanStressCorrection::Kind;
      switch (f.mean_stress)
        {
        case Kind::goodman:
        case Kind::gerber:
          return f.ultimate_strength;
        case Kind::morrow:
          return f.strength_coefficient;
        case Kind::walker:
          return f.walker_exponent;
        case Kind::none:
        case Kind::swt:
          return 0.;
        }
      unknown_choice("mean stress correction");
    }



    double
    over_rest(const double amplitude, const double used)
    {
      return used < 1. ? amplitude / (1. - used)
                       : std::numeric_limits<double>::infinity();
    }
  } // namespace



  MeanStressCorrection::MeanStressCorrection(const Kind   kind,
                                             const double constant)
    : kind(kind)
    , constant(constant)
  {
  }



  MeanStressCorrection::MeanStressCorrection(const FatigueParameters &fatigue)
    : MeanStressCorrection(fatigue.mean_stress, constant_of(fatigue))
  {
  }



  double
  MeanStressCorrection::equivalent_amplitude(const double amplitude,
                                             const double mean) const
  {
    const double maximum = mean + amplitude;
    switch (kind)
      {
      case Kind::none:
        return amplitude;
      case Kind::goodman:
      case Kind::morrow:
        return over_rest(amplitude, mean / constant);
      case Kind::gerber:
        return mean <= 0.
                 ? amplitude
                 : over_rest(amplitude, mean / constant * (mean / constant));
      case Kind::swt:
        return maximum > 0. ? std::sqrt(maximum * amplitude) : 0.;
      case Kind::walker:
        return maximum > 0. ? std::pow(maximum, 1. - constant) *
                                std::pow(amplitude, constant)
                            : 0.;
      }
    unknown_choice("mean stress correction");
  }
} // namespace squeal::tribology
