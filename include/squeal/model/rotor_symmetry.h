// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_model_rotor_symmetry_h
#define squeal_model_rotor_symmetry_h

#include <squeal/discretization/discretization.h>

#include <string>
#include <vector>

namespace squeal
{
  class Model;
  class RunLog;

  /**
   * The numbers n of times a turn in which the mass or the stiffness of some
   * bodies repeats about an axis: the orders up to 64 with a Fourier
   * coefficient |int exp(i n theta) dm| above 0.2 % of the mass, or |int exp(i
   * n theta) C dV| of an elastic constant C along the radial, tangential and
   * axial directions above 0.2 % of the largest one's integral. Empty for a
   * body of revolution of a material that is the same at all angles; circles of
   * facets have the order of their facets where these are few.
   *
   * @param axis   of any length
   * @param centre a point of the axis, m
   */
  std::vector<unsigned int> angular_orders(
    const Discretization            &discretization,
    const std::vector<unsigned int> &bodies,
    const Vector3                   &axis,
    const Vector3                   &centre);

  /** Throws InputError for a body with a `Rotation speed` whose volume has more
   * than 5 % of the orders 1 or 2 about its axis: the terms of turning are
   * those of a body that looks the same at all angles. */
  void refuse_turning_without_axis(const Discretization &discretization);

  /**
   * What the fixed frame leaves out: a line that names each rotor (a body with
   * a `Rotation speed` or the target of a contact with friction, and all that
   * is tied to it) that is no body of revolution in shape and material and
   * stands still at one angle. Empty where there is none.
   */
  std::string frozen_rotors(const Discretization &discretization);

  /** Warns of frozen_rotors() in the log; scenes without a mesh have none. */
  void warn_of_frozen_rotors(const Model &model, RunLog &log);
} // namespace squeal

#endif
