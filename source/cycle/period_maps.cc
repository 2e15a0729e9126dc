// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/cycle/period_maps.h>

namespace squeal
{
  MotionState
  ModeChange::carried_difference(const MotionState &x) const
  {
    return {modes * x.coordinates, modes * x.velocities, x.forces};
  }

  MotionState
  ModeChange::carried(const MotionState &x) const
  {
    return {to_steady + modes * (x.coordinates - from_steady),
            modes * x.velocities,
            x.forces};
  }

  StepCorrections
  ModeChange::carried(const StepCorrections &x) const
  {
    StepCorrections result = x;
    for (auto *vectors : {&result.position, &result.velocity})
      for (Eigen::VectorXd &v : *vectors)
        if (v.size() > 0)
          v = modes * v;
    return result;
  }



  PeriodMaps::Map
  PeriodMaps::find(const double parameter) const
  {
    try
      {
        return at(parameter);
      }
    catch (const ComputationError &)
      {
        return nullptr;
      }
    catch (const InputError &) // beyond what the entry may be
      {
        return nullptr;
      }
  }

  MotionState
  PeriodMaps::carried_difference(const MotionState &x,
                                 const double       from,
                                 const double       to) const
  {
    return share_modes() || from == to ? x
                                       : change(from, to).carried_difference(x);
  }
} // namespace squeal
