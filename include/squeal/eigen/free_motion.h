// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_eigen_free_motion_h
#define squeal_eigen_free_motion_h

namespace squeal
{
  /** Whether a mode of @p omega_squared, (rad/s)^2, is a motion without
   * stiffness: it is 0 to 1e-9 of @p limit, (rad/s)^2. Below 0 rounding is
   * given 1e-7 of it; what lies lower has a negative stiffness, which is no
   * free motion but one that grows without vibrating. */
  inline bool
  is_free_motion(const double omega_squared, const double limit)
  {
    return omega_squared < 1e-9 * limit && omega_squared > -1e-7 * limit;
  }
} // namespace squeal

#endif
