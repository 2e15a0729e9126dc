// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/transient/lagged_friction.h>

#include <algorithm>
#include <cmath>

namespace squeal
{
  namespace
  {
    constexpr double stuck = FrictionLaw::stuck;
    /** Slip below this share of the sliding speed is rounding at the start. */
    constexpr double slip_rounding = 1e-9;
  } // namespace



  LaggedFriction::LaggedFriction(const TransientDrive  &drive,
                                 const Eigen::VectorXd &speed_ratio)
    : added(drive.friction)
    , speed(drive.speed)
    , laws(drive.laws)
    , by_slip_rate(laws && !laws->is_constant())
    , rises(laws && laws->rises())
    , ratio(speed_ratio)
  {
    if (by_slip_rate)
      memory = Eigen::VectorXd::Constant(ratio.size(), stuck);
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
        memory[j] = laws->of(j).remember(
          stuck, slip > slip_rounding * std::abs(v) ? slip : stuck, 0.);
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
    step.nodal_friction.resize(ratio.size());
    step.rising.assign(rises ? ratio.size() : 0, RisingFriction());
    for (Eigen::Index j = 0; j < ratio.size(); ++j)
      {
        const FrictionLaw &law  = laws->of(j);
        const double       more = ratio[j] > 0. ? added(time) : 0.;
        const double       mu =
          by_slip_rate ? law.recalled(memory[j]) : law.at_rest();
        step.nodal_friction[j] = std::max(0., mu + more);
        if (rises)
          step.rising[j] =
            RisingFriction(law, law.range_recalled(memory[j]), more);
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
        memory[j] = laws->of(j).remember(memory[j],
                                         status[j] == ContactStatus::stick
                                           ? stuck
                                           : slip.norm() / step.duration,
                                         step.duration);
      }
  }

  Eigen::VectorXd &
  LaggedFriction::state()
  {
    return memory;
  }

  const Eigen::VectorXd &
  LaggedFriction::state() const
  {
    return memory;
  }
} // namespace squeal
