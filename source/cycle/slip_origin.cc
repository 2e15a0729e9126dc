// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/cycle/slip_origin.h>

#include <algorithm>
#include <cmath>

namespace squeal
{
  namespace
  {
    /** The share of a step after which @p value that has fallen by @p fall in
     * the step before is nothing. */
    std::optional<double>
    share_of_fall(const double value, const double fall)
    {
      if (!(fall > 0.))
        return {};
      return std::clamp(value / fall, 0., 1.);
    }
  } // namespace



  ChangesInStep::ChangesInStep(const ReducedContactModel &m,
                               const Eigen::VectorXd     &mu,
                               const double               speed,
                               const double               step,
                               const Eigen::VectorXd     &f,
                               const Eigen::VectorXd     &u,
                               const ContactPast         &p)
    : model(m)
    , friction(mu)
    , way(speed * step)
    , force(f)
    , motion(u)
    , past(p)
  {
  }

  Eigen::Vector2d
  ChangesInStep::last_slip(const unsigned int j) const
  {
    Eigen::Vector2d slip = past.motion_change.segment<2>(3 * j + 1);
    slip[0] += way * model.speed_ratio[j];
    return slip;
  }

  Eigen::Vector2d
  ChangesInStep::slip_before(const unsigned int j) const
  {
    Eigen::Vector2d slip = past.motion_change_before.segment<2>(3 * j + 1);
    slip[0] += way * model.speed_ratio[j];
    return slip;
  }

  double
  ChangesInStep::gap(const unsigned int j) const
  {
    return std::max(0., model.initial_gap[j] - motion[3 * j]);
  }

  double
  ChangesInStep::gap_change(const unsigned int j) const
  {
    return -past.motion_change[3 * j];
  }

  double
  ChangesInStep::reserve(const unsigned int j, const Eigen::Vector3d &f) const
  {
    return friction[j] * f[0] - f.tail<2>().norm();
  }



  ChangesInStep::Origin
  ChangesInStep::stop(const unsigned int j) const
  {
    // The slip rate at the start, per step, and its change from step to step.
    const Eigen::Vector2d slip = last_slip(j);
    const double          size = slip.norm(),
                 change =
                   size > 0. ? size - slip_before(j).dot(slip) / size : 0.,
                 rate = size + .5 * change;
    Origin result;
    if (!(change < 0. && rate > 0. && rate < -change))
      return result;
    result.share = -rate / change;
    result.slip  = .5 * result.share * rate / size * slip;
    return result;
  }

  ChangesInStep::Closing
  ChangesInStep::closing(const unsigned int j) const
  {
    // Gap and slip go on with their second differences, of a free motion.
    const bool was_free        = past.status_before[j] == ContactStatus::open;
    const Eigen::Vector2d slip = last_slip(j),
                          bend = was_free
                                   ? Eigen::Vector2d(slip - slip_before(j))
                                   : Eigen::Vector2d(0., 0.);
    const double gap_bend =
      was_free ? past.motion_change_before[3 * j] - past.motion_change[3 * j]
               : 0.;
    const double rate = gap_change(j) + .5 * gap_bend,
                 root = rate * rate - 2. * gap_bend * gap(j);
    Closing result;
    if (root >= 0. && std::sqrt(root) > rate)
      result.share = std::min(1., 2. * gap(j) / (std::sqrt(root) - rate));
    const double share = result.share;
    result.slip        = share * slip + .5 * share * (1. + share) * bend;
    result.slip_rate   = slip + (share + .5) * bend;
    result.gap_rate    = rate + share * gap_bend;
    return result;
  }

  ChangesInStep::Origin
  ChangesInStep::origin(const unsigned int j) const
  {
    if (!past.is_known())
      return {};
    if (past.status[j] == ContactStatus::open)
      {
        const Closing c = closing(j);
        return {c.share, c.slip};
      }
    if (past.status[j] == ContactStatus::slip &&
        past.status_before[j] == ContactStatus::slip)
      return stop(j);
    return {};
  }



  Eigen::Vector2d
  ChangesInStep::slip_over_gap(const unsigned int j) const
  {
    if (!past.is_known() || past.status[j] != ContactStatus::open)
      return Eigen::Vector2d::Zero();
    const Closing c = closing(j);
    return c.gap_rate < 0. ? Eigen::Vector2d(c.slip_rate / c.gap_rate)
                           : Eigen::Vector2d(0., 0.);
  }

  std::optional<double>
  ChangesInStep::share(const unsigned int j, const ContactStatus now) const
  {
    if (!past.is_known() || past.status[j] == now)
      return {};
    if (now == ContactStatus::open)
      return share_of_fall(force[3 * j], -past.force_change[3 * j]);
    if (past.status[j] == ContactStatus::open)
      return closing(j).share;
    if (now == ContactStatus::slip)
      {
        const Eigen::Vector3d f      = force.segment<3>(3 * j);
        const double          left   = reserve(j, f);
        const Eigen::Vector3d change = past.force_change.segment<3>(3 * j);
        return share_of_fall(left, reserve(j, f - change) - left);
      }
    const double share = origin(j).share;
    return share > 0. ? std::optional<double>(share) : std::nullopt;
  }
} // namespace squeal
