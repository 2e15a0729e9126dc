// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_eigen_mode_naming_profile_h
#define squeal_eigen_mode_naming_profile_h

#include <Eigen/Core>

namespace squeal
{
  /**
   * Turns the phase of a complex profile such that as much of it as possible
   * is real, and returns that real part. A real profile keeps its shape.
   */
  Eigen::VectorXd most_real_part(const Eigen::VectorXcd &profile);

  /**
   * Number of times a profile changes its sign. Values below @p threshold times
   * the largest one count as neither, so that a clamped end and small wiggles
   * add no node.
   */
  unsigned int n_sign_changes(const Eigen::VectorXd &profile,
                              const double           threshold);
} // namespace squeal

#endif
