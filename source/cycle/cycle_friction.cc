// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/cycle/cycle_friction.h>

namespace squeal
{
  CycleFriction
  CycleFriction::of_laws(const FrictionLaws &laws,
                         const unsigned int  n_nodes,
                         const double        speed)
  {
    if (!laws.is_constant_in_slip())
      throw InputError("periodic motions need one coefficient of friction at "
                       "all slip rates");
    CycleFriction result;
    result.speed   = speed;
    result.at_rest = laws.at_rest(n_nodes);
    result.kinetic = result.at_rest;
    for (unsigned int j = 0; j < n_nodes; ++j)
      result.kinetic[j] = laws.of(j).coefficient(std::abs(speed));
    return result;
  }
} // namespace squeal
