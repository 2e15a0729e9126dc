// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/transient/lagged_friction.h>

#include <algorithm>
#include <cmath>

namespace squeal
{
  namespace
  {
    constexpr double sticks = -1.;
    /** Slip below this share of the sliding speed is rounding at the start. */
    constexpr double rounding = 1e-9;
  } // namespace



  LaggedFriction::LaggedFriction(const TransientDrive  &drive,
                                 const Eigen::VectorXd &speed_ratio)
    : added(drive.friction)
    , speed(drive.speed)
    , law(drive.law && !drive.law->is_constant() ? drive.law : nullptr)
    , ratio(speed_ratio)
  {
    if (drive.law && !law)
      added = [constant = drive.law->at_rest(), f = drive.friction](
                const double time) { return constant + f(time); };
    if (law)
      slip_rate = Eigen::VectorXd::Constant(ratio.size(), sticks);
  }



  void
  LaggedFriction::start(const Eigen::VectorXd &rate)
  {
    if (!law)
      return;
    const double v = speed(0.);
    for (Eigen::Index j = 0; j < ratio.size(); ++j)
      {
        const double slip =
          std::hypot(rate[3 * j + 1] + v * ratio[j], rate[3 * j + 2]);
        slip_rate[j] = slip > rounding * std::abs(v * ratio[j]) ? slip : sticks;
      }
  }



  void
  LaggedFriction::set(const double time, ContactStep &step) const
  {
    step.friction = std::max(0., added(time));
    if (!law)
      return;
    step.nodal_friction.resize(ratio.size());
    for (Eigen::Index j = 0; j < ratio.size(); ++j)
      step.nodal_friction[j] = std::max(
        0.,
        added(time) + (slip_rate[j] < 0. ? law->at_rest()
                                         : law->coefficient(slip_rate[j])));
  }



  void
  LaggedFriction::keep(const ContactStep                &step,
                       const Eigen::VectorXd            &motion,
                       const std::vector<ContactStatus> &status)
  {
    if (!law)
      return;
    for (Eigen::Index j = 0; j < ratio.size(); ++j)
      {
        Eigen::Vector2d slip = motion.segment<2>(3 * j + 1) -
                               step.previous_motion.segment<2>(3 * j + 1);
        slip[0] += step.duration * step.speed * ratio[j];
        slip_rate[j] = status[j] == ContactStatus::stick
                         ? sticks
                         : slip.norm() / step.duration;
      }
  }

  Eigen::VectorXd &
  LaggedFriction::state()
  {
    return slip_rate;
  }

  const Eigen::VectorXd &
  LaggedFriction::state() const
  {
    return slip_rate;
  }
} // namespace squeal
