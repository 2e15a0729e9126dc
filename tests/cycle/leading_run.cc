// SPDX-License-Identifier: LGPL-2.1-or-later

// A motion on its way to the limit cycle of a mass on a belt that lifts off:
// when it has settled, that the cycle is found from there, and which motions
// from other starts count as ending in it.

#include "cycle/two_modes.h"
#include "scenes.h"

#include <squeal/cycle/cycle_trial.h>
#include <squeal/transient/linearized_motion.h>

#include <cmath>
#include <cstdio>
#include <string>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  constexpr double friction = .5, speed = 3., step = .02;

  /** Until it settles or the time is over. */
  unsigned int
  advance_until_settled(LeadingRun &run)
  {
    unsigned int n = 1;
    while (run.advance() && !run.has_settled())
      ++n;
    return n;
  }

  void
  settles(const PeriodMap &map, const SteadySliding &steady)
  {
    LeadingRun short_run(map, {disturbed(steady), {}, 0.}, step, 25., 75., 2.);
    advance_until_settled(short_run);
    check(!short_run.has_settled() && !short_run.lasts(),
          "a motion that still grows has not settled and does not last");
    LeadingRun run(map, {disturbed(steady), {}, 0.}, step, 75., 3000., 2.);
    const unsigned int n = advance_until_settled(run);
    std::printf(
      "settled after %u parts, nearest return %.2e\n", n, run.nearest_return());
    check(run.has_settled() && n < 40, "it settles before its time is over");
    const RunFigures f = run.figures();
    check(f.time > 0. && std::abs(run.end().time - f.time) < 1e-9,
          "its time is that of its end");
    check(f.repetition > .95, "it repeats itself");
  }

  CycleResult
  found_from_the_pair(const PeriodMap        &map,
                      const SteadySliding    &steady,
                      const LinearizedMotion &linear)
  {
    Eigen::Index k;
    linear.lambda.real().maxCoeff(&k);
    LimitCycleParameters settings;
    settings.run_time   = 3000.;
    settings.run_steps  = 400;
    settings.steps      = 1000;
    const CycleResult c = find_cycle(map, steady, linear, k, settings);
    std::printf("cycle of %.5f Hz, rms %.4f N after a run of %.0f s\n",
                c.figures.frequency,
                c.figures.rms_normal,
                c.run.time);
    check(c.status() == "periodic" && c.multipliers.is_stable(),
          "the pair leads to a stable cycle: " + c.status());
    check(c.run.time < settings.run_time,
          "the run ends where the motion has settled");
    // The run has settled to 2 %, and its steps are of first order.
    check_close(c.run.rms_normal,
                c.figures.rms_normal,
                .03,
                "rms of the run and of the cycle");
    return c;
  }

  /** A second belt and mass of their own that do not grow: their share in the
   * growing pair is a trace, and says nothing of where the search starts. */
  void
  beside_a_quiet_pair(const CycleResult &alone)
  {
    const ReducedContactModel one = two_modes();
    ReducedContactModel       m   = empty_model(2, 6);
    for (const Eigen::Index i : {0, 1})
      {
        m.omega_squared.segment(3 * i, 3) = (1. + .3 * i) * one.omega_squared;
        m.damping.segment(3 * i, 3)       = one.damping;
        m.load.segment(3 * i, 3)          = one.load;
        m.participation.block(3 * i, 3 * i, 3, 3) = one.participation;
        m.flexibility.block(3 * i, 3 * i, 3, 3)   = one.flexibility;
      }
    m.damping_coupling       = Eigen::MatrixXd::Zero(6, 6);
    m.damping_coupling(0, 3) = m.damping_coupling(3, 0) = 1e-9;
    NodalFriction in_slip  = NodalFriction::uniform(friction, 2);
    in_slip.coefficient[1] = 0.;
    CycleFriction law;
    law.kinetic                = in_slip.coefficient;
    law.speed                  = speed;
    const SteadySliding steady = steady_sliding(m, in_slip.coefficient);
    const PeriodMap     map(m, law, 1., 1e-12, {1, 1});
    const CycleResult   c =
      found_from_the_pair(map, steady, linearize(m, steady, in_slip, speed));
    // The phase that it starts with is free, and it grows over the period.
    std::printf("amplitude of the start: %.3f sqrt(J), alone %.3f sqrt(J)\n",
                c.half_change,
                alone.half_change);
    check(c.half_change > .5 * alone.half_change &&
            c.half_change < 2. * alone.half_change,
          "the start is that without the quiet pair");
    check_close(c.figures.rms_normal,
                alone.figures.rms_normal,
                1e-3,
                "the cycle is that without the quiet pair");
  }

  /** Motions that end in the cycle if they are given the time. */
  void
  motions_whose_time_runs_out(const PeriodMap     &map,
                              const SteadySliding &steady,
                              const CycleResult   &c)
  {
    const MotionPlace start{disturbed(steady), {}, 0.};
    const double      needed =
      CycleTrials(map, c, step, 2000.).follow("rest", start).time;
    // A part is of twelve periods.
    const double part = 12. / (c.figures.repetitions() * c.figures.frequency);
    const MotionTrial there =
      CycleTrials(map, c, step, needed - 2. * part).follow("rest", start);
    check(there.ends_in,
          "a motion that is in the cycle when its time is over goes on until "
          "it has been there for long enough");
    unsigned int n_undecided = 0;
    for (const double disturbance : {1e-3, 1e-4, 1e-5, 1e-6})
      {
        MotionPlace quiet         = start;
        quiet.state.velocities[0] = disturbance;
        const MotionTrial early =
          CycleTrials(map, c, step, 3. * part).follow("quiet", quiet);
        std::printf("from %.0e: stopped at %.2e of the rms\n",
                    disturbance,
                    early.figures.rms_normal / c.figures.rms_normal);
        n_undecided += early.is_undecided;
        check(!early.ends_elsewhere(), "more time is all that it needs");
        check(!CycleTrials(map, c, step, 2. * part)
                 .follow("quiet", quiet)
                 .ends_elsewhere(),
              "two parts tell nothing");
      }
    check(n_undecided > 0, "one that still grows towards it is undecided");
    CycleResult other = c;
    for (CycleFigures *f : {&other.figures, &other.coarse_figures})
      f->rms_normal *= 1.5;
    check(CycleTrials(map, other, step, 600.)
            .follow_cycle(c.motion)
            .ends_elsewhere(),
          "one that stays beside the cycle ends elsewhere");
  }

  void
  nodes_that_open(const PeriodMap &map, const CycleResult &c)
  {
    PeriodicMotion motion = c.motion;
    for (auto &status : motion.orbit.status)
      status.assign(status.size(), ContactStatus::open);
    check(cycle_figures(map, motion).n_opening == 0,
          "a node that never touches does not open");
    motion.orbit.status.front()[0] = ContactStatus::slip;
    check(cycle_figures(map, motion).n_opening == 1,
          "one that is open and closed does");
  }

  void
  trials(const PeriodMap     &map,
         const SteadySliding &steady,
         const CycleResult   &c)
  {
    const CycleTrials beside(map, c, step, 2000.);
    const MotionTrial from_rest =
      beside.follow("rest", {disturbed(steady), {}, 0.});
    check(from_rest.ends_in, "a motion from steady sliding ends in the cycle");
    check_close(from_rest.frequency,
                c.figures.repetitions() * c.figures.frequency,
                .01,
                "with its frequency");
    const MotionTrial stays = beside.follow_cycle(c.motion);
    check(stays.ends_in, "a motion from the cycle stays there");
    check(stays.time < from_rest.time, "which shows earlier");
    const auto is_other = [&](double CycleFigures::*number,
                              const double          factor,
                              const std::string    &name) {
      CycleResult other = c;
      for (CycleFigures *f : {&other.figures, &other.coarse_figures})
        f->*number *= factor;
      check(!CycleTrials(map, other, step, 600.).follow_cycle(c.motion).ends_in,
            "a cycle that is " + name + " is another one");
    };
    is_other(&CycleFigures::rms_normal, 1.1, "a tenth louder");
    is_other(&CycleFigures::rms_normal, 1.03, "3 % louder");
    is_other(&CycleFigures::frequency, 1.03, "3 % higher");
    is_other(&CycleFigures::frequency, 1.005, "half a percent higher");
    CycleResult growing         = c;
    growing.multipliers.largest = 1.03;
    growing.multipliers.error   = 1e-4;
    const MotionTrial longer =
      CycleTrials(map, growing, step, 600.).follow_cycle(c.motion);
    check(longer.ends_in && std::pow(1.03, longer.periods) > 100.,
          "where a disturbance may grow a motion is followed until it has");
    check_below(stays.periods, 60., "and for some periods elsewhere");
    motions_whose_time_runs_out(map, steady, c);
    nodes_that_open(map, c);
  }
} // namespace

int
main()
{
  const ReducedContactModel m      = two_modes();
  const SteadySliding       steady = steady_sliding(m, friction);
  const LinearizedMotion    linear = linearize(m, steady, friction, speed);
  const PeriodMap           map(m, friction, speed, 1., 1e-12);
  settles(map, steady);
  const CycleResult found = found_from_the_pair(map, steady, linear);
  trials(map, steady, found);
  beside_a_quiet_pair(found);
}
