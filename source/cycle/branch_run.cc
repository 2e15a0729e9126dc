// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/cycle/branch_run.h>
#include <squeal/cycle/branch_step.h>

#include <algorithm>
#include <cmath>

namespace squeal
{
  namespace
  {
    constexpr unsigned int few_iterations = 4, many_iterations = 7;
    constexpr double       longer = 1.5, shorter = 0.5;
    /** How often a step is halved where turns may hide in it. */
    constexpr unsigned int most_closer = 8;

    unsigned int
    changes_of(const Orbit &orbit)
    {
      const unsigned int n      = orbit.n_steps();
      unsigned int       result = 0;
      for (unsigned int i = 0; i < n; ++i)
        for (std::size_t j = 0; j < orbit.status[i].size(); ++j)
          result += orbit.status[i][j] != orbit.status[(i + n - 1) % n][j];
      return result;
    }

    /** Largest angle, rad, between the friction of a node where it slips first
     * in the period and later in it. Along one line friction in slip is linear
     * in the normal force; where it turns, mu lambda_n s/|s| is not. */
    double
    friction_turn_of(const Orbit &orbit)
    {
      double result = 0.;
      for (std::size_t j = 0; j < orbit.status.front().size(); ++j)
        {
          std::optional<Eigen::Vector2d> first;
          for (unsigned int i = 0; i < orbit.n_steps(); ++i)
            {
              const Eigen::Vector2d friction =
                orbit.states[i + 1].forces.segment<2>(3 * j + 1);
              if (orbit.status[i][j] != ContactStatus::slip ||
                  !(friction.norm() > 0.))
                continue;
              if (!first)
                first = friction;
              const double across =
                (*first)[0] * friction[1] - (*first)[1] * friction[0];
              result = std::max(
                result, std::atan2(std::abs(across), first->dot(friction)));
            }
        }
      return result;
    }

    /** Of the vibration of all normal forces and their moments, N. */
    double
    amplitude_of(const BranchPoint &point)
    {
      double sum = 0.;
      for (const auto &values :
           {point.figures.rms_of_pairs(), point.figures.moments_of_pairs()})
        for (const double x : values)
          sum += x * x;
      return std::sqrt(sum);
    }

    /** Whether the motion of the last of @p points is small and vanishes within
     * @p distance of its parameter, which goes there no faster than in
     * proportion to the amplitude. */
    bool
    has_nearly_vanished(const std::vector<BranchPoint> &points,
                        const double                    distance)
    {
      double largest = 0.;
      for (const BranchPoint &point : points)
        largest = std::max(largest, amplitude_of(point));
      const BranchPoint &last   = points.back(),
                        &before = points[points.size() - 2];
      const double a = amplitude_of(before), b = amplitude_of(last);
      return b < a && b <= small_amplitude * largest &&
             std::abs(last.parameter - before.parameter) * b / (a - b) <=
               distance;
    }

    /** Whether an odd number of real multipliers is beyond 1, without the
     * trivial one. */
    bool
    is_odd_beyond(const FloquetMultipliers &multipliers)
    {
      bool result = false;
      for (const std::complex<double> m : multipliers.values)
        if (m != multipliers.trivial && m.imag() == 0. && m.real() > 1.)
          result = !result;
      return result;
    }

    /** Whether a multiplier passes 1 near point @p i: where it is as near to 1
     * as the trivial one, the points beside the neighbours tell. */
    bool
    passes_one(const std::vector<BranchPoint> &points, const std::size_t i)
    {
      const auto first = points.begin() + (i < 2 ? 0 : i - 2),
                 last  = points.begin() + std::min(i + 3, points.size());
      return std::any_of(first, last, [&](const BranchPoint &x) {
        return is_odd_beyond(x.multipliers) !=
               is_odd_beyond(first->multipliers);
      });
    }

    /** Whether real multipliers, without the trivial one, are all further from
     * 1 than @p distance. */
    bool
    are_off_one(const FloquetMultipliers &multipliers, const double distance)
    {
      return std::all_of(multipliers.values.begin(),
                         multipliers.values.end(),
                         [&](const std::complex<double> m) {
                           return m == multipliers.trivial || m.imag() != 0. ||
                                  std::abs(m.real() - 1.) > distance;
                         });
    }

    /** Whether a multiplier passes 1 from @p a to @p b, the points beyond @p
     * before, while the parameter goes on the same way: with a fold it would
     * turn back between them, and turns again. */
    bool
    passes_one_unturned(const BranchPoint &before,
                        const BranchPoint &a,
                        const BranchPoint &b)
    {
      // Near a fold two multipliers are about 1: which of them is the trivial
      // one, which misses 1 by as much as it is uncertain, is not sure.
      double uncertain = 0.;
      for (const BranchPoint *point : {&before, &a, &b})
        uncertain = std::max(uncertain, point->multipliers.uncertainty());
      return (a.parameter - before.parameter) * (b.parameter - a.parameter) >
               0. &&
             is_odd_beyond(a.multipliers) != is_odd_beyond(b.multipliers) &&
             are_off_one(a.multipliers, 4. * uncertain) &&
             are_off_one(b.multipliers, 4. * uncertain);
    }

    void
    mark_folds(std::vector<BranchPoint> &points)
    {
      for (std::size_t i = 1; i + 1 < points.size(); ++i)
        {
          points[i].turns_back =
            (points[i].parameter - points[i - 1].parameter) *
              (points[i + 1].parameter - points[i].parameter) <
            0.;
          points[i].is_fold = points[i].turns_back && passes_one(points, i);
        }
      // A turn at one of the two is what the multiplier has passed 1 at.
      for (std::size_t i = 1; i + 1 < points.size(); ++i)
        points[i].hides_folds =
          passes_one_unturned(points[i - 1], points[i], points[i + 1]) &&
          !points[i + 1].turns_back;
    }
  } // namespace



  BranchRun::BranchRun(PeriodMaps            m,
                       const PeriodicMotion &start,
                       const double          parameter,
                       const BranchSettings &s)
    : maps(std::move(m))
    , settings(s)
  {
    for (const unsigned int i : {0u, 1u})
      {
        sides[i].sign   = i == 0 ? -1. : 1.;
        sides[i].points = {point_of(*maps(parameter), start, parameter)};
      }
  }



  BranchRun::BranchRun(PeriodMaps            m,
                       const NamedNumbers   &start,
                       const BranchSettings &s)
    : maps(std::move(m))
    , settings(s)
  {
    sides[0].sign   = -1.;
    sides[1].sign   = 1.;
    sides[0].points = sides[1].points = {point_from(start)};
  }



  bool
  BranchRun::advance(const Watch &watch)
  {
    for (Side &side : sides)
      while (!end_of(side))
        {
          add_point(side);
          if (watch && watch(n_points()))
            return false;
        }
    return true;
  }

  std::size_t
  BranchRun::n_points() const
  {
    return sides[0].points.size() + sides[1].points.size() - 1;
  }

  const BranchPoint &
  BranchRun::start() const
  {
    return sides[0].points.front();
  }

  CycleBranch
  BranchRun::branch() const
  {
    CycleBranch result;
    const auto &down = sides[0].points, &up = sides[1].points;
    result.first_end = end_of(sides[0]).value_or(BranchEnd::points);
    result.last_end  = end_of(sides[1]).value_or(BranchEnd::points);
    result.points.assign(down.rbegin(), down.rend());
    result.points.insert(result.points.end(), up.begin() + 1, up.end());
    mark_folds(result.points);
    return result;
  }



  BranchPoint
  BranchRun::point_of(const PeriodMap &map,
                      PeriodicMotion   motion,
                      const double     parameter) const
  {
    BranchPoint result;
    result.parameter         = parameter;
    result.n_changes         = changes_of(motion.orbit);
    result.friction_turn     = friction_turn_of(motion.orbit);
    result.multipliers       = floquet_multipliers(map, motion);
    result.figures           = cycle_figures(map, motion);
    result.multipliers.error = settings.multiplier_error;
    result.motion            = std::move(motion);
    return result;
  }

  /** The neighbour of @p start at another parameter, in the direction of @p
   * sign; none where it is not found. */
  std::optional<BranchPoint>
  BranchRun::neighbour(const BranchPoint &start, const double sign) const
  {
    const double first = settings.first_step;
    for (double share = first; share > 1e-3 * first; share *= .25)
      {
        const double parameter = std::clamp(
          start.parameter + sign * share * (settings.upper - settings.lower),
          settings.lower,
          settings.upper);
        if (auto point = point_at(start, parameter))
          return point;
      }
    return {};
  }

  /** The motion near that of @p start at another value of the parameter. */
  std::optional<BranchPoint>
  BranchRun::point_at(const BranchPoint &start, const double parameter) const
  {
    const auto map = maps.find(parameter);
    if (!map)
      return {};
    PeriodicMotion motion =
      shoot(*map,
            maps.carried(
              start.motion.orbit.states.front(), start.parameter, parameter),
            start.motion.period,
            settings.shooting);
    if (motion.status != CycleStatus::converged)
      return {};
    return point_of(*map, std::move(motion), parameter);
  }



  /** @p point, or the motion at the end of the range that it has left; none
   * where that is not found from there. */
  std::optional<BranchPoint>
  BranchRun::within_range(BranchPoint point) const
  {
    const double end =
      std::clamp(point.parameter, settings.lower, settings.upper);
    if (end != point.parameter)
      return point_at(point, end);
    return point;
  }



  std::optional<BranchEnd>
  BranchRun::end_of(const Side &side) const
  {
    const BranchPoint &last = side.points.back();
    if (side.is_lost)
      return side.turns ? BranchEnd::turn : BranchEnd::not_found;
    const bool is_low  = last.parameter <= settings.lower,
               is_high = last.parameter >= settings.upper;
    if (side.points.size() == 1)
      return (side.sign < 0. ? is_low : is_high)
               ? std::optional<BranchEnd>(BranchEnd::range)
               : std::nullopt;
    if (last.n_changes == 0 && last.friction_turn <= onset_turn)
      return BranchEnd::onset;
    if (has_nearly_vanished(side.points,
                            small_distance * (settings.upper - settings.lower)))
      return BranchEnd::small;
    if (settings.is_of_another && settings.is_of_another(last))
      return BranchEnd::joined;
    if (is_low || is_high)
      return BranchEnd::range;
    if (side.points.size() > settings.n_points)
      return BranchEnd::points;
    return {};
  }

  std::optional<BranchPoint>
  BranchRun::step_along(Side &side) const
  {
    const BranchPoint &last   = side.points.back(),
                      &before = side.points[side.points.size() - 2];
    const double way          = branch_distance(maps, before, last, settings);
    unsigned int n_closer     = 0;
    for (double step =
           std::min(side.steps.back() > 0. ? side.steps.back() : way,
                    settings.largest_step);
         step >= settings.smallest_step;
         step *= shorter)
      if (auto next = correct_along(maps, before, last, step, settings))
        {
          side.turns = branch_turn(maps, before, last, *next, settings) >
                       settings.largest_turn;
          if (side.turns)
            continue;
          const unsigned int iterations = next->motion.iterations;
          auto               point      = within_range(point_of(
            *maps(next->parameter), std::move(next->motion), next->parameter));
          const bool         is_hidden  = point &&
                                 passes_one_unturned(before, last, *point) &&
                                 shorter * step >= settings.smallest_step &&
                                 n_closer++ < most_closer;
          if (!point || is_hidden)
            continue;
          side.steps.push_back(iterations <= few_iterations    ? longer * step
                               : iterations >= many_iterations ? shorter * step
                                                               : step);
          return point;
        }
    return {};
  }

  void
  BranchRun::add_point(Side &side) const
  {
    const bool is_first = side.points.size() == 1;
    auto       next =
      is_first ? neighbour(side.points.front(), side.sign) : step_along(side);
    side.is_lost = !next;
    if (!next)
      return;
    if (is_first)
      side.steps.push_back(0.);
    side.points.push_back(std::move(*next));
  }
} // namespace squeal
