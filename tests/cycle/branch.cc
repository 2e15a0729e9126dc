// SPDX-License-Identifier: LGPL-2.1-or-later

// Branches of periodic motions over the coefficient of friction of a mass whose
// two modes couple on a belt: where they begin, against what the linear motion
// and the first change of status predict, and what they have elsewhere, against
// long transients.

#include "cycle/branches.h"
#include "cycle/two_modes.h"
#include "scenes.h"
#include "worst.h"

#include <squeal/base/exceptions.h>
#include <squeal/cycle/branch_run.h>
#include <squeal/cycle/branch_step.h>
#include <squeal/cycle/cycle_search.h>
#include <squeal/transient/linearized_motion.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  /** The vibration that grows fastest. */
  Eigen::Index
  fastest_growing(const LinearizedMotion &linear)
  {
    Eigen::Index k    = 0;
    double       best = -1e300;
    for (Eigen::Index i = 0; i < linear.lambda.size(); ++i)
      if (linear.lambda[i].imag() > 0. && linear.lambda[i].real() > best)
        {
          best = linear.lambda[i].real();
          k    = i;
        }
    return k;
  }

  /** Of the normal force of the linear motion at the critical friction, rms at
   * the amplitude at which the first node opens or sticks. */
  double
  predicted_rms(const ReducedContactModel &m,
                const double               mu,
                const double               speed)
  {
    const PeriodMap        map(m, mu, speed, 1., 1e-12);
    const SteadySliding    steady = steady_sliding(m, mu);
    const LinearizedMotion linear = linearize(m, steady, mu, speed);
    const Eigen::Index     k      = fastest_growing(linear);
    const double           amplitude =
      change_amplitudes(map, steady, linear, k, 20000).front().front();
    const Eigen::Index    n = m.n_modes();
    const Eigen::VectorXd x = .5 * amplitude * linear.right.col(k).real();
    const MotionState     start{
      steady.coordinates + x.head(n), x.segment(n, n), steady.forces};
    // At half the amplitude all is linear.
    return 2. * figures_of(
                  map.run(start, 2. * M_PI / linear.lambda[k].imag(), 20000))
                  .rms;
  }

  /** An eigenvector is the same whatever its phase, and so is the amplitude at
   * which the first node changes its status, however fast the pair grows. */
  void
  start_amplitude()
  {
    const double              mu = .6, speed = .3;
    const ReducedContactModel m = two_modes();
    const PeriodMap           map(m, mu, speed, 1., 1e-12);
    const SteadySliding       steady = steady_sliding(m, mu);
    LinearizedMotion          linear = linearize(m, steady, mu, speed);
    const Eigen::Index        k      = fastest_growing(linear);
    check(2. * M_PI * linear.lambda[k].real() > .3 * linear.lambda[k].imag(),
          "the pair grows much in a period");
    const Eigen::VectorXcd shape = linear.right.col(k);
    const auto             first = [&]() {
      return change_amplitudes(map, steady, linear, k, 2000).front().front();
    };
    const double as_given = first();
    for (const double phase : {1., 2.3, 4.})
      {
        linear.right.col(k) = std::polar(1., phase) * shape;
        check_close(first(),
                    as_given,
                    1e-3,
                    "first change from the phase " + std::to_string(phase));
      }
  }

  /** Whether all numbers of two motions are the same. */
  bool
  same(const BranchPoint &a, const BranchPoint &b)
  {
    const MotionState &x = a.motion.orbit.end(), &y = b.motion.orbit.end();
    return a.parameter == b.parameter && a.motion.period == b.motion.period &&
           a.motion.residual == b.motion.residual &&
           a.motion.iterations == b.motion.iterations &&
           a.multipliers.largest == b.multipliers.largest &&
           a.n_changes == b.n_changes && x.coordinates == y.coordinates &&
           x.velocities == y.velocities && x.forces == y.forces;
  }

  void
  check_same(const CycleBranch &a,
             const CycleBranch &b,
             const std::string &name)
  {
    bool all = a.points.size() == b.points.size() &&
               a.first_end == b.first_end && a.last_end == b.last_end;
    for (std::size_t i = 0; all && i < a.points.size(); ++i)
      all = same(a.points[i], b.points[i]);
    check(all, name + ": every bit");
  }

  template <typename Action>
  void
  check_refused(const Action &action, const std::string &name)
  {
    std::string text;
    try
      {
        action();
      }
    catch (const InputError &e)
      {
        text = e.what();
      }
    check(!text.empty() && text.find('\n') == std::string::npos,
          name + " is refused in one line: " + text);
  }

  /** Stopped half-way, with more points than before, from damaged numbers. */
  void
  resume()
  {
    const ReducedContactModel m        = two_modes();
    const PeriodMaps          maps     = over_friction(m, .3);
    const double              start_at = .5;
    Start                     start    = start_of(m, maps, start_at);
    const auto                run      = [&](const unsigned int n_points) {
      BranchSettings s = start.settings;
      s.n_points       = n_points;
      return BranchRun(maps, start.motion, start_at, s);
    };
    BranchRun whole = run(8), stopped = run(8), resumed = run(8),
              shorter = run(4), extended = run(8);
    check(whole.advance() && whole.n_points() == 17, "a branch of 17 points");
    for (const std::size_t n : {4u, 12u})
      {
        check(!stopped.advance(
                [&](const std::size_t points) { return points >= n; }),
              "stopped at " + std::to_string(n) + " points");
        resumed.restore(NamedNumbers::from_bytes(stopped.memory().bytes()));
        check(resumed.n_points() == n, "continues from there");
      }
    check(resumed.advance(), "to both ends");
    check_same(whole.branch(), resumed.branch(), "stopped");
    check(shorter.advance(), "a shorter branch");
    extended.restore(shorter.memory());
    check(extended.advance(), "made longer");
    check_same(whole.branch(), extended.branch(), "extended");
    BranchRun cut = run(4), grown_again = run(8);
    cut.restore(whole.memory());
    check(cut.n_points() == shorter.n_points() && cut.advance(),
          "no more points than are asked for now");
    check_same(shorter.branch(), cut.branch(), "cut");
    grown_again.restore(cut.memory());
    check(grown_again.advance(), "to both ends again");
    check_same(whole.branch(), grown_again.branch(), "cut and grown again");
    unsigned int n_held = 0;
    for (const BranchPoint &x : whole.branch().points)
      n_held += x.motion.is_held;
    std::printf("resume: %u of %zu points with held corrections\n",
                n_held,
                whole.n_points());

    const NamedNumbers memory = whole.memory();
    for (const char *name : {"0/1/start/forces", "1/2/past/status", "0/steps"})
      {
        NamedNumbers damaged = memory;
        damaged.set(name, std::vector<double>{7., 7.});
        check_refused([&]() { run(8).restore(damaged); }, name);
      }
    NamedNumbers moved = memory;
    moved.set("1/2/period", 1.01 * memory.number("1/2/period"));
    check_refused([&]() { run(8).restore(moved); },
                  "what is no periodic motion of the branch");
  }

  bool
  changes_status(const Orbit &orbit)
  {
    return std::any_of(orbit.status.begin(),
                       orbit.status.end(),
                       [&](const auto &s) { return s != orbit.status[0]; });
  }

  /** On either side of the first change of status: between the first two points
   * of the branch until they are half a percent apart. */
  std::pair<double, double>
  onset_rms(const PeriodMaps     &maps,
            const CycleBranch    &branch,
            const BranchSettings &s)
  {
    BranchPoint before = branch.points[2], last = branch.points[1];
    double      below = figures_of(branch.points[0].motion.orbit).rms,
           above      = figures_of(last.motion.orbit).rms,
           step       = branch_distance(maps, last, branch.points[0], s);
    check(changes_status(last.motion.orbit) &&
            !changes_status(branch.points[0].motion.orbit),
          "the first two points are on either side of the onset");
    while (above > 1.005 * below && step > 1e-6)
      {
        step *= .5;
        const auto next = correct_along(maps, before, last, step, s);
        check(next.has_value(), "a point nearer to the onset");
        const double rms = figures_of(next->motion.orbit).rms;
        if (changes_status(next->motion.orbit))
          {
            before = last;
            last   = *next;
            above  = rms;
          }
        else
          below = rms;
      }
    return {below, above};
  }

  /** From the onset, on either side of the first change of status. */
  void
  check_onset(const PeriodMaps     &maps,
              const CycleBranch    &branch,
              const BranchSettings &settings,
              const double          mu,
              const double          rms)
  {
    check(branch.first_end == BranchEnd::onset, "the branch begins at onset");
    const BranchPoint &linear = branch.points[0];
    const auto [below, above] = onset_rms(maps, branch, settings);
    std::printf("onset: mu %.8f (%.8f), rms %.6f to %.6f N (%.6f)\n",
                linear.parameter,
                mu,
                below,
                above,
                rms);
    check_close(linear.parameter, mu, 1e-4, "friction of the onset");
    check_below(above, 1.005 * below, "the onset is resolved");
    check_below(
      std::max(std::abs(below / rms - 1.), std::abs(above / rms - 1.)),
      1e-2,
      "amplitude of the onset");
  }

  /** At points that are stable, against transients. */
  void
  check_transients(const ReducedContactModel &m,
                   const PeriodMaps          &maps,
                   const CycleBranch         &branch)
  {
    Worst frequency, rms;
    for (const double share : {.5, .75, 1.})
      {
        const auto i =
          static_cast<std::size_t>(share * (branch.points.size() - 2));
        const BranchPoint &x = branch.points[i];
        if (!(x.multipliers.largest < .95))
          continue;
        const auto   map    = maps(x.parameter);
        const double period = x.motion.period;
        MotionState  state  = disturbed(steady_sliding(m, x.parameter));
        const Orbit  tail =
          map->run(later(*map, state, 800., .01), 3. * period, 6000);
        const auto back =
          recurrences(m, tail, .5 * period, 2.5 * period).back();
        const Orbit   one = map->run(tail.end(), back.first, 4000);
        const Figures t = figures_of(one), c = figures_of(x.motion.orbit);
        std::printf("mu %.4f: transient %.6f Hz, %.6f N; branch %.6f Hz, "
                    "%.6f N\n",
                    x.parameter,
                    t.frequency,
                    t.rms,
                    c.frequency,
                    c.rms);
        frequency.add(std::abs(c.frequency / t.frequency - 1.));
        rms.add(std::abs(c.rms / t.rms - 1.));
      }
    check_below(frequency.largest(), 1e-3, "frequency of long transients");
    check_below(rms.largest(), 1e-2, "rms of long transients");
  }

  void
  branch(const double speed, const std::string &name)
  {
    const ReducedContactModel m        = two_modes();
    const PeriodMaps          maps     = over_friction(m, speed);
    const double              critical = critical_friction(m, speed);
    const double              rms      = predicted_rms(m, critical, speed);
    std::printf("%s: critical friction %.8f, rms there %.6f N\n",
                name.c_str(),
                critical,
                rms);
    const Start       start = start_of(m, maps, .5);
    const CycleBranch b = follow_branch(maps, start.motion, .5, start.settings);
    print(b, name);
    check_onset(maps, b, start.settings, critical, rms);
    check_transients(m, maps, b);
    // Where a change of status is about to vanish the multipliers themselves
    // jump: a few points may be off by more.
    Worst               worst;
    std::vector<double> trivial;
    for (const BranchPoint &x : b.points)
      {
        trivial.push_back(std::abs(x.multipliers.trivial - 1.));
        worst.add(trivial.back());
      }
    check_below(worst.largest(), 1e-2, "trivial multiplier on the branch");
    std::sort(trivial.begin(), trivial.end());
    check_below(trivial[trivial.size() * 19 / 20],
                1e-3,
                "trivial multiplier at 95 % of the points");
  }
  /** The friction of the branches over a stiffness. */
  constexpr double mu_of_stiffness = .5;

  /** Over the stiffness along the belt: every value has modes of its own, of
   * either sign. */
  struct OverStiffness
  {
    struct At
    {
      ReducedContactModel model;
      SteadySliding       steady;
      PeriodMap           map;
      explicit At(const ReducedContactModel &m)
        : model(m)
        , steady(steady_sliding(model, mu_of_stiffness))
        , map(model, mu_of_stiffness, .3, 1., 1e-12)
      {
      }
    };

    static std::shared_ptr<const At>
    at(const double stiffness)
    {
      ReducedContactModel m = two_modes(stiffness);
      // As an eigensolver might: a sign that no neighbour has.
      if (static_cast<long>(stiffness * 1e7) % 2 == 0)
        {
          m.participation.col(0) *= -1.;
          m.load[0] *= -1.;
        }
      return std::make_shared<const At>(m);
    }

    /** The modes' parts along and normal to the belt, and the third. */
    static Eigen::MatrixXd
    shapes(const ReducedContactModel &m)
    {
      return m.participation;
    }

    static PeriodMaps
    maps()
    {
      PeriodMaps result;
      result.at = [](const double stiffness) {
        const auto there = at(stiffness);
        return PeriodMaps::Map(there, &there->map);
      };
      result.change = [](const double from, const double to) {
        const auto a = at(from), b = at(to);
        return ModeChange{shapes(b->model).transpose() * shapes(a->model),
                          a->steady.coordinates,
                          b->steady.coordinates};
      };
      return result;
    }
  };

  /** Every point of a branch over a stiffness is a periodic motion of the model
   * with that stiffness: long transients end there. */
  void
  stiffness()
  {
    const PeriodMaps          maps = OverStiffness::maps();
    const double              from = 1.5;
    const ReducedContactModel m    = two_modes(from);
    Start start          = start_of(m, over_friction(m, .3), mu_of_stiffness);
    start.settings.lower = 1.3;
    start.settings.upper = 1.6;
    start.settings.largest_step = .1;
    // Written in the modes that the branch has there: those of the hand-made
    // model have the other sign, like those of a value just beside.
    start.motion =
      shoot(*maps(from),
            maps.carried(start.motion.orbit.states.front(), from + 1e-7, from),
            start.motion.period,
            start.settings.shooting);
    check(start.motion.status == CycleStatus::converged, "the start");
    const CycleBranch b =
      follow_branch(maps, start.motion, from, start.settings);
    print(b, "stiffness");
    check(b.first_end == BranchEnd::range && b.last_end == BranchEnd::range,
          "the branch goes from one end of the range to the other");
    check_close(b.points.front().parameter, 1.3, 1e-12, "its lower end");
    check_close(b.points.back().parameter, 1.6, 1e-12, "its upper end");
    Worst frequency, rms;
    for (const BranchPoint *x : {&b.points.front(), &b.points.back()})
      {
        const auto   there  = OverStiffness::at(x->parameter);
        const double period = x->motion.period;
        check_below(x->multipliers.largest, .98, "a stable cycle");
        const Orbit tail =
          there->map.run(later(there->map, disturbed(there->steady), 800., .01),
                         3. * period,
                         6000);
        const auto back =
          recurrences(there->model, tail, .5 * period, 2.5 * period).back();
        const Figures t = figures_of(
                        there->map.run(tail.end(), back.first, 4000)),
                      c = figures_of(x->motion.orbit);
        std::printf("stiffness %.4f: transient %.6f Hz, %.6f N; branch %.6f "
                    "Hz, %.6f N\n",
                    x->parameter,
                    t.frequency,
                    t.rms,
                    c.frequency,
                    c.rms);
        frequency.add(std::abs(c.frequency / t.frequency - 1.));
        rms.add(std::abs(c.rms / t.rms - 1.));
      }
    check_below(frequency.largest(), 1e-3, "frequency of long transients");
    check_below(rms.largest(), 1e-2, "rms of long transients");
  }

  /** A branch that comes back from a fold in long steps goes on to the onset,
   * once through every motion: a shift along the period, which every step
   * would hand on to the next, does not turn it round. */
  void
  folding()
  {
    const double        speed = .15;
    ReducedContactModel m     = two_modes(.8);
    // Where nodes give way along the belt, too, forces follow the shift.
    m.flexibility                   = Eigen::Matrix3d::Identity();
    const PeriodMaps   maps         = over_friction(m, speed);
    const double       critical     = critical_friction(m, speed, 1.);
    const unsigned int n            = 128;
    const double       start_at     = 1.03 * critical;
    Start              start        = start_of(m, maps, start_at, n);
    start.settings                  = {};
    start.settings.lower            = .5 * critical;
    start.settings.upper            = 1.06 * critical;
    start.settings.shooting.n_steps = n;
    // Wherever in its period the motion starts.
    for (unsigned int i = 0; i < n; i += n / 8)
      {
        const PeriodicMotion later = shoot(*maps(start_at),
                                           start.motion.orbit.states[i],
                                           start.motion.period,
                                           start.settings.shooting);
        check(later.status == CycleStatus::converged, "the start");
        const CycleBranch b =
          follow_branch(maps, later, start_at, start.settings);
        print(b, "folding");
        check(b.first_end == BranchEnd::onset,
              "the branch goes on from its fold to the onset");
        check_close(
          b.points.front().parameter, critical, 1e-3, "friction of the onset");
        bool grows = true, all_folds = true;
        for (std::size_t k = 0; k < b.points.size(); ++k)
          {
            all_folds =
              all_folds && b.points[k].is_fold == b.points[k].turns_back;
            grows =
              grows &&
              (k == 0 || .99 * figures_of(b.points[k - 1].motion.orbit).rms <
                           figures_of(b.points[k].motion.orbit).rms);
          }
        check(grows, "the amplitude grows all along the branch");
        check(all_folds, "a multiplier passes 1 where the branch turns back");
      }
  }

} // namespace

int
main(int argc, char *argv[])
{
  const std::string which = argc > 1 ? argv[1] : "";
  if (which == "separating")
    branch(3., which);
  else if (which == "sticking")
    branch(.3, which);
  else if (which == "start_amplitude")
    start_amplitude();
  else if (which == "resume")
    resume();
  else if (which == "stiffness")
    stiffness();
  else if (which == "folding")
    folding();
  else
    check(false,
          "an argument: separating, sticking, stiffness, folding, "
          "start_amplitude or resume");
}
