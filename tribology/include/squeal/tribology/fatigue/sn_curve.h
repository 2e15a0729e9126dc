// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_fatigue_sn_curve_h
#define squeal_tribology_fatigue_sn_curve_h

#include <cstddef>
#include <vector>

namespace squeal::tribology
{
  struct FatigueParameters;

  /**
   * Cycles to failure against the fully reversed amplitude S: Basquin's line
   * N = C (S_ref / S)^m; below an optional knee a second slope, the two lines
   * meeting there; amplitudes up to an optional endurance limit live for ever.
   */
  struct SnCurve
  {
    double exponent         = 5.;  /**< m */
    double constant         = 1.;  /**< C, cycles at S_ref */
    double reference_stress = 1e6; /**< S_ref, Pa */
    double knee_stress      = 0.;  /**< Pa; 0: no knee */
    double second_exponent  = 0.;
    double endurance_limit  = 0.; /**< Pa */

    /** 1/N: the damage of one cycle. */
    double damage(double amplitude) const;

    /** Damages of @p n cycles; whole powers are products. */
    void damage(const double *amplitudes, std::size_t n, double *damages) const;

    /** Cycles to failure, may be infinite. */
    double life(double amplitude) const;

  private:
    void damage_of_block(const double *amplitudes,
                         std::size_t   n,
                         double       *damages) const;
  };

  /** The curves of the section "Fatigue", one for each exponent. */
  std::vector<SnCurve> sn_curves(const FatigueParameters &fatigue);
} // namespace squeal::tribology

#endif
