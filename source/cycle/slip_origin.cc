// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/cycle/slip_origin.h>

#include <algorithm>
#include <cmath>

namespace squeal
{
  namespace
  {
    /** By how much friction exceeds the limit of slip where it is more than
     * rounding and the tolerance of the contact. */
    constexpr double above_slip = 1e-6;
    /** A release a little behind the end of the step counts to it: what the
     * last steps tell is not so exact, and a node that lets go within a step by
     * the law alone does not do so at a time that moves with its forces. */
    constexpr double latest_release = 1.1;

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
                               const CycleFriction       &law,
                               const double               step,
                               const Eigen::VectorXd     &f,
                               const Eigen::VectorXd     &u,
                               const ContactPast         &p)
    : model(m)
    , friction(law)
    , way(law.speed * step)
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
    return friction.limit_at_rest(j) * f[0] - f.tail<2>().norm();
  }

  Eigen::Vector3d
  ChangesInStep::force_of(const unsigned int j) const
  {
    return force.segment<3>(3 * j);
  }

  double
  ChangesInStep::fall_of_reserve(const unsigned int j) const
  {
    const Eigen::Vector3d f = force_of(j);
    return reserve(j, f - past.force_change.segment<3>(3 * j)) - reserve(j, f);
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
    if (!past.is_known())
      return {};
    if (past.status[j] == now)
      return now == ContactStatus::slip ? release(j) : std::nullopt;
    if (now == ContactStatus::open)
      return share_of_fall(force[3 * j], -past.force_change[3 * j]);
    if (past.status[j] == ContactStatus::open)
      return closing(j).share;
    if (now == ContactStatus::slip)
      return friction.jumps(j)
               ? release(j)
               : share_of_fall(reserve(j, force_of(j)), fall_of_reserve(j));
    const double share = origin(j).share;
    return share > 0. ? std::optional<double>(share) : std::nullopt;
  }



  std::optional<double>
  ChangesInStep::release(const unsigned int j) const
  {
    if (!past.is_known() || !friction.jumps(j))
      return {};
    const Eigen::Vector3d f    = force_of(j);
    const double          left = reserve(j, f);
    if (past.status[j] == ContactStatus::stick)
      {
        const double fall = fall_of_reserve(j);
        return left <= 0. ? std::optional<double>(0.)
               : left < latest_release * fall
                 ? std::optional<double>(left / fall)
                 : std::nullopt;
      }
    // It has let go in the step before, earlier than was told.
    const bool is_above =
      f.tail<2>().norm() > (1. + above_slip) * friction.kinetic[j] * f[0];
    return past.status[j] == ContactStatus::slip &&
               past.status_before[j] == ContactStatus::stick && is_above
             ? std::optional<double>(0.)
             : std::nullopt;
  }

  bool
  ChangesInStep::is_held_at_rest(const unsigned int j) const
  {
    // A start of which nothing is known may stick.
    return !past.is_known() ||
           (past.status[j] == ContactStatus::stick && !release(j));
  }

  std::pair<Eigen::Vector3d, Eigen::Vector3d>
  ChangesInStep::release_by_forces(const unsigned int j) const
  {
    const double fall = fall_of_reserve(j);
    if (!(fall > 0.))
      return {Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
    const double          left = reserve(j, force_of(j));
    const Eigen::Vector3d before =
      force_of(j) - past.force_change.segment<3>(3 * j);
    const auto by_reserve = [&](const Eigen::Vector3d &f) {
      Eigen::Vector3d result;
      result << friction.limit_at_rest(j), -f.tail<2>().normalized();
      return result;
    };
    return {(1. + left / fall) / fall * by_reserve(force_of(j)),
            -left / (fall * fall) * by_reserve(before)};
  }

  Eigen::Vector3d
  ChangesInStep::jump(const unsigned int j, const double share) const
  {
    Eigen::Vector3d at =
      force_of(j) + share * past.force_change.segment<3>(3 * j);
    const double size = at.tail<2>().norm();
    at.tail<2>() *=
      size > 0. ? friction.kinetic[j] * std::max(0., at[0]) / size - 1. : 0.;
    at[0] = 0.;
    return at;
  }

  BesideLine
  ChangesInStep::beside_line(const unsigned int     j,
                             const double           share,
                             const Eigen::Vector3d &end) const
  {
    const Eigen::Vector3d before =
      share * (force_of(j) + past.force_change.segment<3>(3 * j) - end);
    return release(j) ? beside_line(share, before, before + jump(j, share))
                      : beside_line(share, before, before);
  }

  BesideLine
  ChangesInStep::beside_line(const double           share,
                             const Eigen::Vector3d &before,
                             const Eigen::Vector3d &after)
  {
    const Eigen::Vector3d impulse =
                            .5 * (share * before + (1. - share) * after),
                          moment =
                            share * share / 3. * before +
                            (2. * share + 1.) * (1. - share) / 6. * after;
    return {4. * impulse - 6. * moment, 6. * moment - 2. * impulse};
  }
} // namespace squeal
