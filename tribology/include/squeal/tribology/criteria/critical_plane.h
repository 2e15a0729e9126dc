// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_criteria_critical_plane_h
#define squeal_tribology_criteria_critical_plane_h

#include <squeal/tribology/criteria/multiaxial.h>

#include <functional>

namespace squeal::tribology
{
  /** What happens in one plane over a history. */
  struct PlaneLoad
  {
    double normal_maximum   = 0.; /**< largest normal stress, Pa */
    double normal_amplitude = 0.; /**< of the normal strain, none */
    double shear_amplitude  = 0.; /**< Pa */
  };

  /** A criterion that grows with each of the three. */
  using PlaneCriterion = std::function<double(const PlaneLoad &)>;

  /**
   * The plane in which @p criterion is largest: planes @p step degrees apart
   * over the half sphere, then a compass search down to 1e-7 rad about each of
   * the up to sixteen best ones that stand apart, as maxima of a similar height
   * are told from each other only there. Planes whose upper bound is too low
   * are left out.
   */
  CriterionValue search_planes(const StressHistory  &history,
                               const MaterialLimits &limits,
                               const PlaneCriterion &criterion,
                               double                step);
} // namespace squeal::tribology

#endif
