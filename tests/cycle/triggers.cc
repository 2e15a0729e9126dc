// SPDX-License-Identifier: LGPL-2.1-or-later

// The smallest impulse that leads to a vibration that lasts: bisection with
// fates that are known, the oscillator on a belt whose threshold is known in
// closed form, and a mass whose friction turns, which leaves steady sliding for
// good without a change of status.

#include "cycle/two_modes.h"
#include "scenes.h"
#include "worst.h"

#include <squeal/cycle/cycle_search.h>
#include <squeal/cycle/edge_trajectory.h>
#include <squeal/cycle/trigger_threshold.h>
#include <squeal/transient/linearized_motion.h>

#include <cmath>
#include <cstdio>
#include <string>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  using Status = TriggerThreshold::Status;

  constexpr double known = .3137, tolerance = 1e-3;

  MotionFate
  above_known(const double impulse)
  {
    return impulse > known ? MotionFate::squeals : MotionFate::returns;
  }

  void
  check_bracket(const TriggerThreshold &t, const std::string &name)
  {
    check(t.status == Status::bracketed && t.lower <= known &&
            t.upper >= known && t.upper - t.lower <= tolerance * t.upper,
          name + " is bracketed to the tolerance: " + std::to_string(t.lower) +
            " to " + std::to_string(t.upper));
  }

  void
  known_fates()
  {
    const TriggerThreshold t =
      find_threshold(above_known, {.1, .2, .4, .8}, tolerance);
    check_bracket(t, "a known threshold");
    check(t.n_changes == 1, "there is one change along the ladder");
    check(t.trials.front().impulse == .8, "the largest is tried first");
    check_bracket(find_threshold(above_known, {.8}, tolerance),
                  "a threshold below the only impulse");
    const TriggerThreshold back = find_threshold(
      [](const double impulse) {
        return impulse > .5 && impulse < .6 ? MotionFate::returns
                                            : above_known(impulse);
      },
      {.2, .4, .55, .8},
      tolerance);
    check_bracket(back, "the lowest of several thresholds");
    check(back.n_changes == 3, "a larger impulse that returns is noticed");
    check(find_threshold(
            [](double) { return MotionFate::returns; }, {.1, .2}, tolerance)
              .status == Status::no_squeal,
          "without squeal there is no threshold");
    check(find_threshold(
            [](double) { return MotionFate::squeals; }, {.1, .2}, tolerance)
              .status == Status::none_returns,
          "where all squeal there is no threshold");
    const auto lingers = [](const double impulse) {
      return std::abs(impulse - known) < .02 ? MotionFate::undecided
                                             : above_known(impulse);
    };
    const TriggerThreshold open = find_threshold(lingers, {.1, .4}, tolerance);
    check(open.status == Status::undecided && open.is_found() &&
            open.lower < known && open.upper > known &&
            lingers(open.lower) == MotionFate::returns &&
            lingers(open.upper) == MotionFate::squeals,
          "what is undecided leaves a bracket of decided impulses");
    check(find_threshold(
            [](double) { return MotionFate::undecided; }, {.1, .2}, tolerance)
              .status == Status::undecided_at_largest,
          "an undecided largest impulse has its own status");
  }

  void
  near_a_guess()
  {
    TriggerThreshold guess;
    guess.lower = .31;
    guess.upper = .32;
    check_bracket(find_threshold_near(above_known, guess, tolerance),
                  "a guess that holds");
    guess.lower = .32;
    guess.upper = .33;
    check_bracket(find_threshold_near(above_known, guess, tolerance),
                  "a guess above the threshold");
    guess.lower = .30;
    guess.upper = .31;
    check_bracket(find_threshold_near(above_known, guess, tolerance),
                  "a guess below the threshold");
    guess.lower = .1;
    guess.upper = .101;
    check(find_threshold_near(above_known, guess, tolerance).status ==
            Status::not_there,
          "a guess far from the threshold is refused");
  }



  constexpr double belt = .1, kinetic = .3, at_rest = .5, ratio = .05;

  /** The force of 1 N along y on the mass of foot_on_belt(), not on its foot.
   */
  ModalForce
  on_the_mass(const ReducedContactModel &m)
  {
    // The modes of 0.9 and 0.1 kg are orthonormal in the mass.
    const Eigen::Vector2d foot = -m.participation.block<1, 2>(1, 2).transpose();
    Eigen::Vector2d       mass(foot[1], -foot[0]);
    mass *=
      std::copysign(1. / (std::sqrt(.9) * mass.norm()), mass[0] * foot[0]);
    ModalForce force{Eigen::VectorXd::Zero(m.n_modes()),
                     Eigen::VectorXd::Zero(3),
                     Eigen::VectorXd(),
                     Eigen::VectorXd()};
    force.modal.tail<2>() = mass;
    return force;
  }

  /**
   * It slides on for ever while its velocity stays below that of the belt. A
   * blow m v against the belt swings it back with the velocity
   * v exp(-2 zeta acos(zeta)/sqrt(1 - zeta^2)). Once it sticks it goes on doing
   * so. Returns the relative error of the threshold.
   */
  double
  stick_slip(const double step, const std::string &name)
  {
    // Windows of some twenty periods, whose beginning and end do not matter.
    constexpr double    duration = .2;
    ReducedContactModel m        = foot_on_belt(step);
    m.omega_squared[1]           = 1.;
    m.damping[0]                 = 2. / std::sqrt(m.flexibility(0, 0));
    m.damping[1]                 = .2;
    m.damping[2]                 = 2. * ratio;
    CycleFriction friction;
    friction.kinetic = Eigen::VectorXd::Constant(1, kinetic);
    friction.at_rest = Eigen::VectorXd::Constant(1, at_rest);
    friction.speed   = belt;
    const PeriodMap      map(m, friction, 1., 1e-11);
    const SteadySliding  steady = steady_sliding(m, kinetic);
    const MotionFollower follower(map, steady, {step, 160., 320., 960.});
    const ModalForce     unit   = on_the_mass(m);
    const auto           motion = [&](const double                 impulse,
                            const std::optional<double> &lasting) {
      return follower.follow(
        struck_motion(map, steady, unit, -impulse, duration, step), lasting);
    };
    const FollowedMotion strongest = motion(.4, std::nullopt);
    check(strongest.fate == MotionFate::squeals,
          name + ": the largest blow ends in stick and slip");
    const TriggerThreshold t = find_threshold(
      [&](const double impulse) {
        return motion(impulse, strongest.lasting_forces()).fate;
      },
      {.05, .1, .2, .4},
      2e-3);
    // A half sine moves an oscillator by this share of its impulse.
    const double of_blow = std::cos(.5 * duration) /
                           (1. - std::pow(duration / M_PI, 2)),
                 swing    = std::exp(2. * ratio * std::acos(ratio) /
                                  std::sqrt(1. - ratio * ratio)),
                 expected = belt / of_blow * swing;
    std::printf("%s: %.5f to %.5f N s, closed form %.5f, %zu trials\n",
                name.c_str(),
                t.lower,
                t.upper,
                expected,
                t.trials.size());
    check(t.status == Status::bracketed && t.n_changes == 1,
          name + ": there is one threshold");
    return std::abs(t.middle() / expected - 1.);
  }

  /** Changes of status at the ends of steps make the error one of first order;
   * the bracket adds 1e-3. */
  void
  against_the_belt()
  {
    const double whole = stick_slip(.004, "whole steps"),
                 half  = stick_slip(.002, "half steps");
    check_below(whole, 2e-2, "threshold of the oscillator on a belt");
    check_below(half, 1e-2, "with half the steps");
    check_below(half, .5 * whole + 2e-3, "of first order");
  }



  constexpr double turning_friction = .52, turning_speed = .5,
                   turning_load = 100.;

  /** 0.1 kg on springs in three directions, pressed on a belt by 100 N: its
   * friction turns. Beside stable steady sliding stand an unstable cycle of
   * 1021.6 Hz and 29.7 N rms in which the node slips all the time, and a stable
   * one of 985 Hz and 64.8 N. */
  ReducedContactModel
  mass_in_three_directions()
  {
    constexpr double mass = .1, alpha = 20., beta = 2e-6;
    Eigen::Matrix3d  K; // along x, y and the normal, N/m
    K << 3631234.8706482691, 515453.23818839953, -301259.25792361051,
      515453.23818839953, 3997226.5672543352, -961549.47100799216,
      -301259.25792361051, -961549.47100799216, 1971538.5620973955;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> modes(K / mass);
    ReducedContactModel                                  m = empty_model(1, 3);
    m.omega_squared           = modes.eigenvalues();
    m.damping                 = alpha + beta * modes.eigenvalues().array();
    const Eigen::Matrix3d phi = modes.eigenvectors() / std::sqrt(mass);
    m.participation.row(0)    = -phi.row(2);
    m.participation.row(1)    = -phi.row(0);
    m.participation.row(2)    = phi.row(1);
    m.load                    = -turning_load * phi.row(2).transpose();
    m.flexibility             = Eigen::Vector3d(4e-7, 2e-7, 2e-7).asDiagonal();
    return m;
  }

  /** An own integrator of this mass has the threshold at 0.05367 +- 0.00003 N
   * s: the motion after 0.0575 N s falls for some 10 ms, as its faster modes
   * die, then rises, and is in the stable cycle after 0.2 s. */
  void
  leaves_while_it_slips()
  {
    const ReducedContactModel m = mass_in_three_directions();
    CycleFriction             friction;
    friction.kinetic = Eigen::VectorXd::Constant(1, turning_friction);
    friction.speed   = turning_speed;
    const PeriodMap       map(m, friction, turning_load, 1e-10);
    const SteadySliding   steady = steady_sliding(m, turning_friction);
    constexpr double      step = 8e-6, duration = 2e-4;
    const MotionFollower  follower(map, steady, {step, .002, .012, 1.6});
    const Eigen::Vector3d direction = Eigen::Vector3d(.3, -.5, 1.).normalized();
    ModalForce            unit{Eigen::VectorXd::Zero(3),
                    Eigen::VectorXd::Zero(3),
                    Eigen::VectorXd(),
                    Eigen::VectorXd()};
    unit.modal = direction[0] * -m.participation.row(1).transpose() +
                 direction[1] * m.participation.row(2).transpose() +
                 direction[2] * -m.participation.row(0).transpose();
    const auto motion = [&](const double                 impulse,
                            const std::optional<double> &lasting) {
      return follower.follow(
        struck_motion(map, steady, unit, impulse, duration, step), lasting);
    };
    const FollowedMotion strongest = motion(.08, std::nullopt);
    check(strongest.fate == MotionFate::squeals, "the largest blow squeals");
    const double         lasting = strongest.lasting_forces();
    const FollowedMotion above   = motion(.0575, lasting),
                         below   = motion(.02, lasting);
    std::printf("lasts with %.2f N rms; 0.0575 N s: %s after %.3f s, 0.02 N s: "
                "%s after %.3f s\n",
                lasting,
                fate_text(above.fate).c_str(),
                above.end.time,
                fate_text(below.fate).c_str(),
                below.end.time);
    check(above.fate == MotionFate::squeals,
          "a blow above the threshold, whose motion falls at first and slips "
          "all the time, squeals");
    check(below.fate == MotionFate::returns &&
            below.windows.back().friction_turn <= linear_turn,
          "one far below it returns, once its friction hardly turns");
  }
} // namespace

int
main(int argc, char *argv[])
{
  const std::string which = argc > 1 ? argv[1] : "";
  if (which == "bisection")
    {
      known_fates();
      near_a_guess();
    }
  else if (which == "stick_slip")
    {
      against_the_belt();
    }
  else if (which == "turning")
    {
      leaves_while_it_slips();
    }
  else
    check(false, "an argument: bisection, stick_slip or turning");
}
