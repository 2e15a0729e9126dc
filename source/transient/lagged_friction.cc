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
    , laws(drive.laws)
    , by_slip_rate(laws && !laws->is_constant())
    , ratio(speed_ratio)
  {
    if (by_slip_rate)
      slip_rate = Eigen::VectorXd::Constant(ratio.size(), sticks);
  }



  void
  LaggedFriction::start(const Eigen::VectorXd &rate)
  {
    if (!by_slip_rate)
      return;
    const double v = speed(0.);
    for (Eigen::Index j = 0; j < ratio.size(); ++j)
      {
        const double slip =
          std::hypot(rate[3 * j + 1] + v * ratio[j], rate[3 * j + 2]);
        slip_rate[j] = slip > rounding * std::abs(v) ? slip : sticks;
      }
  }



  void
  LaggedFriction::set(const double time, ContactStep &step) const
  {
    if (!laws)
      {
        step.friction = std::max(0., added(time));
        return;
      }
    const double more = added(time);
    step.nodal_friction.resize(ratio.size());
    for (Eigen::Index j = 0; j < ratio.size(); ++j)
      {
        const bool   is_known = by_slip_rate && slip_rate[j] >= 0.;
        const double mu       = is_known ? laws->of(j).coefficient(slip_rate[j])
                                         : laws->of(j).at_rest();
        step.nodal_friction[j] = std::max(0., mu + (ratio[j] > 0. ? more : 0.));
      }
  }



  void
  LaggedFriction::keep(const ContactStep                &step,
                       const Eigen::VectorXd            &motion,
                       const std::vector<ContactStatus> &status)
  {
    if (!by_slip_rate)
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
