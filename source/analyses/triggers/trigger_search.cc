// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/analyses/triggers/trigger_search.h>
#include <squeal/base/timers.h>
#include <squeal/cycle/orbit_forces.h>
#include <squeal/model/period_map_of.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace squeal
{
  namespace
  {
    /** The last part of a motion that its cycle is sought in. */
    constexpr double run_of_cycle = 0.02; // s

    FateSettings
    fate_settings(const Parameters &p, const double step)
    {
      return {step, p.triggers.window, p.triggers.hold, p.triggers.longest};
    }

    /** Blows of any size at one point, and what they lead to. */
    class Blows
    {
    public:
      Blows(const PeriodMap     &map,
            const SteadySliding &steady,
            const ModalForce    &force,
            const Parameters    &p,
            const double         time_step)
        : follower(map, steady, fate_settings(p, time_step))
        , unit(force)
        , duration(p.triggers.duration)
        , step(time_step)
      {
      }

      MotionPlace
      struck(const double impulse) const
      {
        return struck_motion(follower.period_map(),
                             follower.steady_sliding(),
                             unit,
                             impulse,
                             duration,
                             step);
      }

      FollowedMotion
      motion(const double impulse, const std::optional<double> &lasting) const
      {
        return follower.follow(struck(impulse), lasting);
      }

      const MotionFollower follower;

    private:
      const ModalForce &unit;
      const double      duration, step;
    };

    /** The motion after the largest impulse of @p p, and the threshold. */
    std::pair<FollowedMotion, TriggerThreshold>
    threshold_of(const Blows &blows, const Parameters &p)
    {
      const TriggersParameters &t         = p.triggers;
      const double              largest   = t.impulses.back();
      FollowedMotion            strongest = blows.motion(largest, std::nullopt);
      const auto                fate      = [&](const double impulse) {
        return impulse == largest
                                     ? strongest.fate
                                     : blows.motion(impulse, strongest.lasting_forces()).fate;
      };
      // Without a vibration that lasts nothing can be told of smaller ones.
      TriggerThreshold threshold =
        strongest.fate == MotionFate::squeals
          ? find_threshold(fate, t.impulses, t.tolerance)
          : find_threshold(fate, {largest}, t.tolerance);
      return {std::move(strongest), std::move(threshold)};
    }

    /** The cycle near the end of @p run by its frequency @p f, Hz, or by half
     * of it where every second period is another one. */
    CycleResult
    cycle_of(const Blows      &blows,
             const Orbit      &run,
             const double      f,
             const Parameters &p)
    {
      const std::vector<double> periods =
        f > 0. ? std::vector<double>{1. / f, 2. / f} : std::vector<double>{};
      return find_cycle_near(
        blows.follower.period_map(), run.end(), periods, p.limit_cycle);
    }

    void
    find_cycles(const Blows &blows, const Parameters &p, TriggerResult &result)
    {
      MotionPlace last = result.strongest.end;
      const auto  n    = static_cast<unsigned int>(
        std::ceil(run_of_cycle / blows.follower.window()));
      const Orbit  run = blows.follower.orbit(last, n);
      const double f   = line_of(blows.follower.period_map(),
                               run,
                               p.eigen.lowest_frequency,
                               p.eigen.highest_frequency)
                         .frequency;
      result.stable = cycle_of(blows, run, f, p);
      if (result.has_edge())
        result.unstable =
          cycle_of(blows, result.edge.tail, result.edge.frequency, p);
    }
  } // namespace



  bool
  TriggerResult::has_threshold() const
  {
    return threshold.is_found();
  }

  bool
  TriggerResult::has_edge() const
  {
    return !edge.stretches.empty();
  }

  const TriggerThreshold &
  TriggerResult::best() const
  {
    return finer.is_found() ? finer : threshold;
  }

  double
  TriggerResult::impulse_error() const
  {
    return finer.is_found() ? .5 * (finer.upper - finer.lower) +
                                std::abs(finer.middle() - threshold.middle())
                            : std::numeric_limits<double>::quiet_NaN();
  }



  TriggerResult
  find_trigger(const SteadyModel      &about,
               const LinearizedMotion &linear,
               const std::string      &name,
               const ModalForce       &unit,
               const Parameters       &p,
               Timers                 &timers)
  {
    TriggerResult result;
    result.point              = name;
    result.threshold.status   = TriggerThreshold::Status::not_there;
    result.finer.status       = TriggerThreshold::Status::not_there;
    Eigen::Index least_stable = 0;
    linear.lambda.real().maxCoeff(&least_stable);
    result.pair = linear.lambda[least_stable];
    if (!(result.pair.real() < 0.))
      {
        result.status = "steady sliding is unstable";
        return result;
      }
    const PeriodMap map  = period_map_of(about);
    const double    step = p.transient.time_step;
    const Blows     blows(map, about.sliding, unit, p, step),
      finer(map, about.sliding, unit, p, .5 * step);
    {
      Timers::Section section(timers, "Solve: thresholds");
      std::tie(result.strongest, result.threshold) = threshold_of(blows, p);
      result.status = threshold_text(result.threshold.status);
      if (!result.has_threshold())
        return result;
      const double lasting = result.strongest.lasting_forces();
      result.finer         = find_threshold_near(
        [&](const double impulse) {
          return finer.motion(impulse, lasting).fate;
        },
        result.threshold,
        p.triggers.tolerance);
      if (!result.finer.is_found())
        result.status = threshold_text(result.finer.status);
      result.below = blows.motion(result.threshold.lower, lasting);
      result.above = blows.motion(result.threshold.upper, lasting);
    }
    if (p.triggers.edge_time > 0.)
      {
        Timers::Section section(timers, "Solve: edge");
        result.edge = follow_edge(blows.follower,
                                  blows.struck(result.threshold.lower),
                                  blows.struck(result.threshold.upper),
                                  result.strongest.lasting_forces(),
                                  {p.triggers.edge_time,
                                   p.triggers.halvings,
                                   p.eigen.lowest_frequency,
                                   p.eigen.highest_frequency});
      }
    Timers::Section section(timers, "Solve: limit cycles");
    find_cycles(blows, p, result);
    return result;
  }
} // namespace squeal
