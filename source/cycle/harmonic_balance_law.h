// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_cycle_harmonic_balance_law_h
#define squeal_cycle_harmonic_balance_law_h

#include <squeal/cycle/harmonic_balance.h>

namespace squeal
{
  /** The projected law at a node and how it changes. */
  struct HarmonicBalance::Law
  {
    ContactStatus   status = ContactStatus::open;
    Eigen::Vector3d missed = Eigen::Vector3d::Zero(); /**< lambda - P, N */
    /** By lambda, u and its rate. */
    Eigen::Matrix3d by_force  = Eigen::Matrix3d::Identity(),
                    by_motion = Eigen::Matrix3d::Zero(),
                    by_rate   = Eigen::Matrix3d::Zero();
  };
} // namespace squeal

#endif
