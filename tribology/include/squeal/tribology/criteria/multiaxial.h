// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_criteria_multiaxial_h
#define squeal_tribology_criteria_multiaxial_h

#include <squeal/tribology/setup/damage_parameters.h>

#include <array>
#include <vector>

namespace squeal::tribology
{
  /** xx, yy, zz, xy, yz, xz in Pa, tension positive. */
  using Stress        = std::array<double, 6>;
  using StressHistory = std::vector<Stress>;

  /** Fatigue limits and strengths of a material, Pa. */
  struct MaterialLimits
  {
    double axial          = 300e6; /**< s, fully reversed tension */
    double torsion        = 190e6; /**< t, fully reversed torsion */
    double repeated       = 250e6; /**< amplitude in repeated bending */
    double yield          = 300e6;
    double fatemi_socie_k = 0.3;
    double tensile        = 300e6;
    double compressive    = 3e9;
    double youngs_modulus = 2.1e11;
    double poisson_ratio  = 0.3;

    /** @name Factors of the criteria */
    //@{
    double dang_van_a() const;  /**< 3 (t/s - 1/2) */
    double crossland_a() const; /**< 3 t/s - sqrt 3 */
    double sines_a() const;     /**< from the repeated limit */
    double findley_k() const;   /**< q / sqrt(1 - q^2), q = 2 t/s - 1 */
    double findley_f() const;   /**< t sqrt(1 + k^2) */
    //@}
  };

  /** The limits of the section "Subsurface"; @p reference_stress stands in for
   * an axial limit that is not given. */
  MaterialLimits material_limits(const SubsurfaceParameters &subsurface,
                                 double                      reference_stress);

  /** Whether a limit of the material that a criterion is judged by was given;
   * else its value is over the reference stress, an index. */
  bool has_limit(SubsurfaceParameters::Criterion criterion,
                 const SubsurfaceParameters     &subsurface);


  /** What a criterion says about one point. */
  struct CriterionValue
  {
    double value = 0.; /**< Pa; SWT Pa, Fatemi-Socie none */
    double limit = 1.; /**< the same unit: value >= limit fails */
    /** Normal of the critical plane, zero for criteria without planes. */
    std::array<double, 3> normal{{0., 0., 0.}};

    /** value over limit: 1 is the limit. */
    double
    utilisation() const
    {
      return value / limit;
    }

    /** Degrees between the normal and the z axis (into the pad), 0 to 90. */
    double inclination() const;

    /** Degrees of the horizontal part, from +x, of the normal that points into
     * the pad: above -180 to 180, as a plane that dips with the sliding is
     * another one than that which dips against it. Of upright planes, whose
     * two normals are alike, above -90 to 90. */
    double azimuth() const;

    /** False where the criterion searches no plane, or its value is 0 in all
     * of them, so that none is critical. */
    bool has_plane() const;
  };

  /** Hydrostatic stress. */
  double hydrostatic(const Stress &stress);

  /** Principal stresses in descending order. */
  std::array<double, 3> principal_stresses(const Stress &stress);

  /** Radius of the smallest ball round the deviator's path, as sqrt(J2). */
  double sqrt_j2_amplitude(const StressHistory &history);

  /**
   * Evaluates one criterion over a history that is a whole number of periods
   * of a cyclic load.
   *
   *  Dang Van       max_t (tau(t) + a s_H(t)), tau the Tresca shear of the
   *                 deviator minus the centre of the smallest ball; limit t
   *  Crossland      sqrt(J2)_a + a max s_H; limit t
   *  Sines          sqrt(J2)_a + a mean s_H (mid of the extremes); limit t
   *  Findley        max over planes of tau_a + k s_n,max; limit f
   *  SWT            max over planes of <s_n,max> de_n/2; limit s^2/E
   *  Fatemi-Socie   max over planes of dgamma/2 (1 + k <s_n,max>/s_y); limit
   *                 the value in fully reversed torsion at t, t/G times the
   *                 maximum over its planes
   *  Rankine        largest principal stress; limit the tensile strength
   *  Drucker-Prager sqrt(J2) + alpha I1 through both strengths
   *
   * <s> is max(s, 0): compression does not lengthen a life. tau_a is the radius
   * of the smallest circle round the shear path in the
   * plane. Planes are searched @p plane_step degrees apart, then refined.
   * Throws ComputationError for a stress that is not finite.
   */
  CriterionValue evaluate_criterion(SubsurfaceParameters::Criterion criterion,
                                    const StressHistory            &history,
                                    const MaterialLimits           &limits,
                                    double plane_step = 5.);
} // namespace squeal::tribology

#endif
