// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_fatigue_mean_stress_h
#define squeal_tribology_fatigue_mean_stress_h

#include <squeal/tribology/setup/damage_parameters.h>

namespace squeal::tribology
{
  /**
   * The fully reversed amplitude that does the same damage as @p amplitude
   * about @p mean (Pa, tension positive):
   *
   *   Goodman  S_a / (1 - S_m / S_u)
   *   Gerber   S_a / (1 - (S_m / S_u)^2), S_a under compression
   *   Morrow   S_a / (1 - S_m / s_f')
   *   SWT      sqrt(S_max S_a), 0 where S_max <= 0
   *   Walker   S_max^(1 - gamma) S_a^gamma, 0 where S_max <= 0
   *
   * Infinite where the mean alone breaks the material.
   */
  class MeanStressCorrection
  {
  public:
    using Kind = FatigueParameters::MeanStress;

    /** @p constant is S_u, s_f' or gamma. */
    explicit MeanStressCorrection(Kind kind = Kind::none, double constant = 0.);

    /** With the constant of the section "Fatigue". */
    explicit MeanStressCorrection(const FatigueParameters &fatigue);

    double equivalent_amplitude(double amplitude, double mean) const;

    bool
    is_none() const
    {
      return kind == Kind::none;
    }

  private:
    Kind   kind;
    double constant;
  };
} // namespace squeal::tribology

#endif
