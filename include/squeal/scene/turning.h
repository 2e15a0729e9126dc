// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_scene_turning_h
#define squeal_scene_turning_h

#include <squeal/parameters/scene_parameters.h>

#include <deal.II/base/point.h>
#include <deal.II/base/symmetric_tensor.h>

namespace squeal
{
  /** The body whose `Rotation speed`, axis and `Angle` hold for body @p number:
   * itself, or of a layer the body that it lies on. */
  const BodyParameters &carrier_of(const SceneParameters &scene,
                                   const unsigned int     number);

  /** Where @p x (m, at the angle 0) is when the body stands at its `Angle`. */
  dealii::Point<3> turned_point(const BodyParameters   &body,
                                const dealii::Point<3> &x);

  /** Where the `Position` of a body is (m) at its `Angle`. */
  dealii::Point<3> turned_position(const BodyParameters &body);

  /** Where the centre of gravity of a rigid body is (m) at its `Angle`. */
  dealii::Point<3> centre_of_gravity(const BodyParameters &rigid);

  /** The tensor that has the principal values @p values along x, y and z at the
   * angle 0, when the body stands at its `Angle`: R diag(values) R^T, in the
   * unit of the values. Exactly diagonal at the angle 0. */
  dealii::SymmetricTensor<2, 3> turned_tensor(const BodyParameters &body,
                                              const Vector3        &values);

  /** Where a lumped mass is (m): it turns with the body that carries it. */
  dealii::Point<3> place_of(const SceneParameters      &scene,
                            const LumpedMassParameters &mass);
} // namespace squeal

#endif
