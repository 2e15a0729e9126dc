// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_scene_turning_h
#define squeal_scene_turning_h

#include <squeal/parameters/scene_parameters.h>

#include <deal.II/base/point.h>

namespace squeal
{
  /** The body whose `Rotation speed`, axis and `Angle` hold for body @p number:
   * itself, or of a layer the body that it lies on. */
  const BodyParameters &carrier_of(const SceneParameters &scene,
                                   const unsigned int     number);

  /** Where @p x (m, at the angle 0) is when the body stands at its `Angle`. */
  dealii::Point<3> turned_point(const BodyParameters   &body,
                                const dealii::Point<3> &x);

  /** Where a lumped mass is (m): it turns with the body that carries it. */
  dealii::Point<3> place_of(const SceneParameters      &scene,
                            const LumpedMassParameters &mass);
} // namespace squeal

#endif
