// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/cycle/orbit.h>

namespace squeal
{
  ContactPast
  Orbit::past_of(const unsigned int i) const
  {
    if (i == 0)
      return past;
    ContactPast result;
    result.force_change  = states[i].forces - states[i - 1].forces;
    result.motion_change = motions[i] - motions[i - 1];
    result.status        = status[i - 1];
    result.motion_change_before =
      i > 1 ? motions[i - 1] - motions[i - 2] : past.motion_change;
    result.status_before = i > 1 ? status[i - 2] : past.status;
    return result;
  }
} // namespace squeal
