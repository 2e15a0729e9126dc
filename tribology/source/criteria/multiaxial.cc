// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/unknown_choice.h>
#include <squeal/tribology/criteria/critical_plane.h>
#include <squeal/tribology/criteria/enclosing_ball.h>

#include <algorithm>
#include <cmath>

namespace squeal::tribology
{
  namespace
  {
    /** The deviator as a point whose length is sqrt(J2). */
    Point5
    deviator(const Stress &s)
    {
      Point5 p;
      p << (2. * s[0] - s[1] - s[2]) / (2. * std::sqrt(3.)), .5 * (s[1] - s[2]),
        s[3], s[4], s[5];
      return p;
    }



    Stress
    from_deviator(const Point5 &p)
    {
      const double xx = p(0) * 2. / std::sqrt(3.);
      return {{xx, -.5 * xx + p(1), -.5 * xx - p(1), p(2), p(3), p(4)}};
    }



    std::vector<Point5>
    deviators(const StressHistory &history)
    {
      std::vector<Point5> points;
      for (const Stress &stress : history)
        points.push_back(deviator(stress));
      return points;
    }



    CriterionValue
    dang_van(const StressHistory &history, const MaterialLimits &limits)
    {
      const Ball5    ball = smallest_enclosing_ball(deviators(history));
      CriterionValue result;
      result.value = -1e300;
      result.limit = limits.torsion;
      for (const Stress &stress : history)
        {
          const std::array<double, 3> p =
            principal_stresses(from_deviator(deviator(stress) - ball.centre));
          result.value = std::max(result.value,
                                  .5 * (p[0] - p[2]) +
                                    limits.dang_van_a() * hydrostatic(stress));
        }
      return result;
    }



    CriterionValue
    drucker_prager(const StressHistory &history, const MaterialLimits &limits)
    {
      const double sum = std::sqrt(3.) * (limits.compressive + limits.tensile);
      const double alpha = (limits.compressive - limits.tensile) / sum;
      CriterionValue result;
      result.value = -1e300;
      result.limit = 2. * limits.compressive * limits.tensile / sum;
      for (const Stress &stress : history)
        result.value =
          std::max(result.value,
                   deviator(stress).norm() + 3. * alpha * hydrostatic(stress));
      return result;
    }



    CriterionValue
    findley(const StressHistory  &history,
            const MaterialLimits &limits,
            const double          step)
    {
      const double   k      = limits.findley_k();
      CriterionValue result = search_planes(
        history,
        limits,
        [k](const PlaneLoad &p) {
          return p.shear_amplitude + k * p.normal_maximum;
        },
        step);
      result.limit = limits.findley_f();
      return result;
    }



    CriterionValue
    swt(const StressHistory  &history,
        const MaterialLimits &limits,
        const double          step)
    {
      CriterionValue result = search_planes(
        history,
        limits,
        [](const PlaneLoad &p) {
          return std::max(p.normal_maximum, 0.) * p.normal_amplitude;
        },
        step);
      result.limit = limits.axial * limits.axial / limits.youngs_modulus;
      return result;
    }



    CriterionValue
    fatemi_socie(const StressHistory  &history,
                 const MaterialLimits &limits,
                 const double          step)
    {
      const double g =
        limits.youngs_modulus / (2. * (1. + limits.poisson_ratio));
      const double   k      = limits.fatemi_socie_k / limits.yield;
      CriterionValue result = search_planes(
        history,
        limits,
        [k, g](const PlaneLoad &p) {
          return p.shear_amplitude / g *
                 (1. + k * std::max(p.normal_maximum, 0.));
        },
        step);
      // torsion: tau_a = t cos 2x, s_n = t sin 2x at x from the plane of the
      // largest shear; the maximum of cos (1 + kt sin) in closed form
      const double kt = k * limits.torsion;
      const double sin =
        kt > 0. ? (std::sqrt(1. + 8. * kt * kt) - 1.) / (4. * kt) : 0.;
      result.limit =
        limits.torsion / g * std::sqrt(1. - sin * sin) * (1. + kt * sin);
      return result;
    }



    CriterionValue
    rankine(const StressHistory &history, const MaterialLimits &limits)
    {
      CriterionValue result;
      result.value = -1e300;
      result.limit = limits.tensile;
      for (const Stress &stress : history)
        result.value = std::max(result.value, principal_stresses(stress)[0]);
      return result;
    }



    /** Crossland with the largest hydrostatic stress, Sines with its mean. */
    CriterionValue
    of_invariants(const StressHistory  &history,
                  const MaterialLimits &limits,
                  const bool            is_crossland)
    {
      double highest = -1e300, lowest = 1e300;
      for (const Stress &stress : history)
        {
          highest = std::max(highest, hydrostatic(stress));
          lowest  = std::min(lowest, hydrostatic(stress));
        }
      CriterionValue result;
      result.limit = limits.torsion;
      result.value =
        sqrt_j2_amplitude(history) +
        (is_crossland ? limits.crossland_a() * highest
                      : limits.sines_a() * .5 * (highest + lowest));
      return result;
    }
  } // namespace



  double
  MaterialLimits::dang_van_a() const
  {
    return 3. * (torsion / axial - .5);
  }



  double
  MaterialLimits::crossland_a() const
  {
    return 3. * torsion / axial - std::sqrt(3.);
  }



  double
  MaterialLimits::sines_a() const
  {
    return 3. * torsion / repeated - std::sqrt(3.);
  }



  double
  MaterialLimits::findley_k() const
  {
    const double q = 2. * torsion / axial - 1.;
    return q / std::sqrt(1. - q * q);
  }



  double
  MaterialLimits::findley_f() const
  {
    const double k = findley_k();
    return torsion * std::sqrt(1. + k * k);
  }



  MaterialLimits
  material_limits(const SubsurfaceParameters &s, const double reference_stress)
  {
    const auto given = [](const double value, const double otherwise) {
      return value > 0. ? value : otherwise;
    };
    MaterialLimits limits;
    limits.axial          = given(s.axial_limit, reference_stress);
    limits.torsion        = s.torsion_ratio * limits.axial;
    limits.repeated       = given(s.repeated_limit, limits.axial * 5. / 6.);
    limits.yield          = given(s.yield_stress, limits.axial);
    limits.fatemi_socie_k = s.fatemi_socie_k;
    limits.tensile        = given(s.tensile_strength, limits.axial);
    limits.compressive    = given(s.compressive_strength, 10. * limits.tensile);
    limits.youngs_modulus = s.youngs_modulus;
    limits.poisson_ratio  = s.poisson_ratio;
    return limits;
  }



  bool
  has_limit(const SubsurfaceParameters::Criterion criterion,
            const SubsurfaceParameters           &s)
  {
    using C = SubsurfaceParameters::Criterion;
    return s.axial_limit > 0. ||
           (s.tensile_strength > 0. &&
            (criterion == C::rankine || criterion == C::drucker_prager));
  }



  bool
  CriterionValue::has_plane() const
  {
    return value != 0. && std::hypot(normal[0], normal[1], normal[2]) > 0.;
  }



  double
  CriterionValue::inclination() const
  {
    return std::acos(std::min(1., std::abs(normal[2]))) * 180. / M_PI;
  }



  double
  CriterionValue::azimuth() const
  {
    // Of the two normals the one into the pad; upright planes have none.
    constexpr double upright = 1e-6;
    const double     sense   = normal[2] < -upright ? -1. : 1.;
    const double     angle =
      std::atan2(sense * normal[1], sense * normal[0]) * 180. / M_PI;
    if (std::abs(normal[2]) > upright)
      return angle;
    return angle > 90. ? angle - 180. : angle <= -90. ? angle + 180. : angle;
  }



  double
  hydrostatic(const Stress &s)
  {
    return (s[0] + s[1] + s[2]) / 3.;
  }



  std::array<double, 3>
  principal_stresses(const Stress &s)
  {
    // the angle of the deviator's third invariant
    const double mean = hydrostatic(s);
    const double x = s[0] - mean, y = s[1] - mean, z = s[2] - mean;
    const double j2 =
      .5 * (x * x + y * y + z * z) + s[3] * s[3] + s[4] * s[4] + s[5] * s[5];
    if (j2 <= 0.)
      return {{mean, mean, mean}};
    const double j3 = x * (y * z - s[4] * s[4]) -
                      s[3] * (s[3] * z - s[4] * s[5]) +
                      s[5] * (s[3] * s[4] - y * s[5]);
    const double r = 2. * std::sqrt(j2 / 3.);
    const double angle =
      std::acos(std::clamp(4. * j3 / (r * r * r), -1., 1.)) / 3.;
    return {{mean + r * std::cos(angle),
             mean + r * std::cos(angle - 2. * M_PI / 3.),
             mean + r * std::cos(angle + 2. * M_PI / 3.)}};
  }



  double
  sqrt_j2_amplitude(const StressHistory &history)
  {
    return smallest_enclosing_ball(deviators(history)).radius;
  }



  CriterionValue
  evaluate_criterion(const SubsurfaceParameters::Criterion criterion,
                     const StressHistory                  &history,
                     const MaterialLimits                 &limits,
                     const double                          plane_step)
  {
    using C = SubsurfaceParameters::Criterion;
    // Maxima over time and planes would drop a NaN.
    for (const Stress &stress : history)
      for (const double component : stress)
        if (!std::isfinite(component))
          throw ComputationError("a stress below the surface is not finite");
    switch (criterion)
      {
      case C::dang_van:
        return dang_van(history, limits);
      case C::crossland:
        return of_invariants(history, limits, true);
      case C::sines:
        return of_invariants(history, limits, false);
      case C::findley:
        return findley(history, limits, plane_step);
      case C::swt:
        return swt(history, limits, plane_step);
      case C::fatemi_socie:
        return fatemi_socie(history, limits, plane_step);
      case C::drucker_prager:
        return drucker_prager(history, limits);
      case C::rankine:
        return rankine(history, limits);
      }
    unknown_choice("criterion");
  }
} // namespace squeal::tribology
