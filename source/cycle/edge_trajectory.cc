// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/unknown_choice.h>
#include <squeal/cycle/edge_trajectory.h>
#include <squeal/cycle/orbit_forces.h>

#include <algorithm>
#include <cmath>

namespace squeal
{
  namespace
  {
    /** Motions whose forces differ by more, over their mean, have gone apart.
     */
    constexpr double apart = 0.05;
    /** Restarts in a row whose motions go apart in the first window. */
    constexpr unsigned int most_failures = 4;

    using Stretch = EdgeTrajectory::Stretch;

    MotionPlace
    middle_of(const MotionPlace &a, const MotionPlace &b)
    {
      return {{.5 * (a.state.coordinates + b.state.coordinates),
               .5 * (a.state.velocities + b.state.velocities),
               .5 * (a.state.forces + b.state.forces)},
              {},
              a.time};
    }

    bool
    are_apart(const MotionWindow &a, const MotionWindow &b)
    {
      return !(std::abs(a.rms_forces - b.rms_forces) <=
               .5 * apart * (a.rms_forces + b.rms_forces));
    }

    /** Halves the way between both; ends early at a middle that is undecided,
     * which is on the edge as far as can be told. */
    void
    halve(const MotionFollower &follower,
          const double          lasting,
          const unsigned int    n,
          MotionPlace          &lower,
          MotionPlace          &upper)
    {
      // A motion without its past differs a little from the same with it.
      lower.past = upper.past = {};
      for (unsigned int i = 0; i < n; ++i)
        {
          const MotionPlace middle = middle_of(lower, upper);
          const MotionFate  fate   = follower.follow(middle, lasting).fate;
          if (fate == MotionFate::undecided)
            return;
          (fate == MotionFate::returns ? lower : upper) = middle;
        }
    }

    /** Moves both on while they agree, for @p longest, s, at most; what they do
     * until then. */
    Stretch
    follow_both(const MotionFollower &follower,
                const double          longest,
                MotionPlace          &lower,
                MotionPlace          &upper)
    {
      Stretch      result;
      const double end = lower.time + longest;
      while (lower.time < end)
        {
          MotionPlace        a = lower, b = upper;
          const MotionWindow of_a = follower.advance(a),
                             of_b = follower.advance(b);
          if (are_apart(of_a, of_b))
            break;
          result.lower.push_back(of_a);
          result.upper.push_back(of_b);
          lower = std::move(a);
          upper = std::move(b);
        }
      return result;
    }

    /** Mean of the normal resultant and rms of what is judged over the last
     * whole periods. */
    void
    set_forces(const PeriodMap &map, EdgeTrajectory &edge)
    {
      const Orbit &run = edge.tail;
      const double period =
        edge.frequency > 0. ? 1. / (edge.frequency * run.step) : run.n_steps();
      // Whole periods, or all where they are not known.
      const auto n = static_cast<unsigned int>(
        std::max(1., std::floor(run.n_steps() / period + 1e-9)) *
        std::min<double>(period, run.n_steps()));
      PairForces forces = pair_forces(map, run);
      for (Eigen::MatrixXd &f : forces)
        f = Eigen::MatrixXd(f.rightCols(n));
      const JudgedRows  rows    = judged_rows(forces);
      const std::size_t loudest = loudest_pair(forces, rows);
      edge.mean_normal          = forces[loudest].row(normal_row).mean();
      edge.rms_normal           = rms_of(forces[loudest].row(rows[loudest]));
      edge.judged_force         = moment_name(map, loudest, rows[loudest]);
    }
  } // namespace



  std::string
  edge_text(const EdgeTrajectory::Status status)
  {
    switch (status)
      {
      case EdgeTrajectory::Status::followed:
        return "followed";
      case EdgeTrajectory::Status::lost:
        return "lost";
      }
    unknown_choice("status of an edge");
  }



  EdgeTrajectory
  follow_edge(const MotionFollower &follower,
              MotionPlace           lower,
              MotionPlace           upper,
              const double          lasting,
              const EdgeSettings   &settings)
  {
    EdgeTrajectory edge;
    MotionPlace    start      = lower;
    unsigned int   n_failures = 0;
    while (lower.time < settings.time && n_failures < most_failures)
      {
        halve(follower, lasting, settings.halvings, lower, upper);
        const MotionPlace here = lower;
        Stretch stretch = follow_both(follower, settings.time, lower, upper);
        if (stretch.lower.empty())
          {
            ++n_failures;
            continue;
          }
        n_failures = 0;
        start      = here;
        edge.stretches.push_back(std::move(stretch));
      }
    if (edge.stretches.empty() || n_failures == most_failures)
      {
        edge.status = EdgeTrajectory::Status::lost;
        if (edge.stretches.empty())
          return edge;
      }
    edge.tail = follower.orbit(start, edge.stretches.back().lower.size());
    edge.end  = start.time;
    const OrbitLine line = line_of(
      follower.period_map(), edge.tail, settings.lowest, settings.highest);
    edge.frequency  = line.frequency;
    edge.repetition = line.repetition;
    set_forces(follower.period_map(), edge);
    return edge;
  }
} // namespace squeal
