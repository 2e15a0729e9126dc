// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/unknown_choice.h>
#include <squeal/cycle/branch_step.h>

#include <algorithm>
#include <cmath>

namespace squeal
{
  namespace
  {
    constexpr unsigned int few_iterations = 4, many_iterations = 7;
    constexpr double       longer = 1.5, shorter = 0.5;

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

    BranchPoint
    point_of(const PeriodMap      &map,
             PeriodicMotion        motion,
             const double          parameter,
             const BranchSettings &s)
    {
      BranchPoint result;
      result.parameter         = parameter;
      result.n_changes         = changes_of(motion.orbit);
      result.multipliers       = floquet_multipliers(map, motion);
      result.figures           = cycle_figures(map, motion);
      result.multipliers.error = s.multiplier_error;
      result.motion            = std::move(motion);
      return result;
    }

    /** The neighbour of @p start at another parameter, in the direction of
     * @p sign; none where it is not found. */
    std::optional<BranchPoint>
    neighbour(const PeriodMaps     &maps,
              const BranchPoint    &start,
              const double          sign,
              const BranchSettings &s)
    {
      for (double share = s.first_step; share > 1e-3 * s.first_step;
           share *= .25)
        {
          const double parameter =
            start.parameter + sign * share * (s.upper - s.lower);
          const auto     map    = maps(parameter);
          PeriodicMotion motion = shoot(*map,
                                        start.motion.orbit.states.front(),
                                        start.motion.period,
                                        s.shooting);
          if (motion.status == CycleStatus::converged)
            return point_of(*map, std::move(motion), parameter, s);
        }
      return {};
    }

    /** Adds the points to one side of the only one of @p points. */
    BranchEnd
    extend(const PeriodMaps         &maps,
           std::vector<BranchPoint> &points,
           const double              sign,
           const BranchSettings     &s)
    {
      auto next = neighbour(maps, points.front(), sign, s);
      if (!next)
        return BranchEnd::not_found;
      double step = -1.; // as long as the one before
      for (points.push_back(std::move(*next));; points.push_back(*next))
        {
          const BranchPoint &last = points.back();
          if (last.n_changes == 0)
            return BranchEnd::onset;
          if (last.parameter < s.lower || last.parameter > s.upper)
            return BranchEnd::range;
          if (points.size() > s.n_points)
            return BranchEnd::points;
          const BranchPoint &before = points[points.size() - 2];
          const double       way    = branch_distance(maps, before, last, s);
          step = std::min(step > 0. ? step : way, s.largest_step);
          for (;; step *= shorter)
            {
              if (step < s.smallest_step)
                return BranchEnd::not_found;
              next = correct_along(maps, before, last, step, s);
              if (next)
                break;
            }
          *next = point_of(*maps(next->parameter),
                           std::move(next->motion),
                           next->parameter,
                           s);
          if (next->motion.iterations <= few_iterations)
            step *= longer;
          else if (next->motion.iterations >= many_iterations)
            step *= shorter;
        }
    }

    void
    mark_folds(std::vector<BranchPoint> &points)
    {
      for (std::size_t i = 1; i + 1 < points.size(); ++i)
        points[i].is_fold = (points[i].parameter - points[i - 1].parameter) *
                              (points[i + 1].parameter - points[i].parameter) <
                            0.;
    }
  } // namespace



  std::string
  branch_end_text(const BranchEnd end)
  {
    switch (end)
      {
      case BranchEnd::range:
        return "end of the range";
      case BranchEnd::points:
        return "as many points as asked for";
      case BranchEnd::onset:
        return "onset";
      case BranchEnd::not_found:
        return "not converged";
      }
    unknown_choice("end of a branch");
  }



  CycleBranch
  follow_branch(const PeriodMaps     &maps,
                const PeriodicMotion &start,
                const double          parameter,
                const BranchSettings &settings)
  {
    CycleBranch              result;
    const auto               map = maps(parameter);
    std::vector<BranchPoint> down{point_of(*map, start, parameter, settings)},
      up             = down;
    result.first_end = extend(maps, down, -1., settings);
    result.last_end  = extend(maps, up, 1., settings);
    result.points.assign(down.rbegin(), down.rend());
    result.points.insert(result.points.end(), up.begin() + 1, up.end());
    mark_folds(result.points);
    return result;
  }
} // namespace squeal
