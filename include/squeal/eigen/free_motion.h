// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_eigen_free_motion_h
#define squeal_eigen_free_motion_h

#include <squeal/eigen/undamped_modes.h>

#include <string>

namespace squeal
{
  /** Whether a mode of @p omega_squared, (rad/s)^2, may be a motion without
   * stiffness: it is 0 to 1e-9 of @p limit, (rad/s)^2. Below 0 rounding is
   * given 1e-7 of it; what lies lower has a negative stiffness, which is no
   * free motion but one that grows without vibrating. */
  inline bool
  is_free_motion(const double omega_squared, const double limit)
  {
    return omega_squared < 1e-9 * limit && omega_squared > -1e-7 * limit;
  }

  /** Motions that nothing holds. */
  struct FreeMotions
  {
    /** Mass-orthonormal, owned rows x motions. */
    Block shapes;
    /** Hz: below it rounding leaves a motion no stiffness to tell from none. */
    double frequency_of_rounding = 0.;

    /** "3 motions at 0 Hz are held by nothing", with @p of_bodies behind it and
     * then the frequency of rounding. */
    std::string text(const std::string &of_bodies = "") const;
  };

  /** What rounding leaves of a sum of stiffnesses of both signs, relative to
   * the sum of their sizes: of those computed here some tens of units in the
   * last place, of those read from files of ten digits. */
  constexpr double rounding_of_computed_stiffness = 1e-14,
                   rounding_of_read_stiffness     = 1e-10;

  /**
   * Those among @p modes of @p pencil, the modes up to @p limit, (rad/s)^2.
   *
   * A body on soft springs may lie as far below a wide band as the rounding of
   * its modes, which is relative to the limit. So what is_free_motion() is
   * looked at once more: the motion x of the stiffness k = x^T K x is free
   * where k is no more than rounding leaves of its sum, @p rounding times
   * |x|^T |K| |x|, or of the limit, 1e-15 of it.
   */
  FreeMotions find_free_motions(
    const Pencil        &pencil,
    const UndampedModes &modes,
    const double         limit,
    const double         rounding = rounding_of_computed_stiffness);
} // namespace squeal

#endif
