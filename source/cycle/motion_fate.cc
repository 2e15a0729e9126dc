// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/unknown_choice.h>
#include <squeal/cycle/motion_fate.h>
#include <squeal/cycle/orbit_forces.h>
#include <squeal/cycle/shooting.h>

#include <algorithm>
#include <cmath>

namespace squeal
{
  namespace
  {
    /** Vibrations whose forces agree so well are the same. */
    constexpr double same_forces = 0.05;

    MotionState
    state_of(const SteadySliding &steady)
    {
      return {steady.coordinates,
              Eigen::VectorXd::Zero(steady.coordinates.size()),
              steady.forces};
    }

    unsigned int
    rounded_count(const double whole, const double part)
    {
      return static_cast<unsigned int>(std::max(1., std::round(whole / part)));
    }

    /** Largest angle, rad, between the friction of @p forces and that of @p
     * steady, of nodes that slip in both. A node whose friction turns is not
     * linear: a slow motion of finite amplitude may last though no node ever
     * changes its status. */
    double
    friction_turn_from(const SteadySliding              &steady,
                       const Eigen::VectorXd            &forces,
                       const std::vector<ContactStatus> &status)
    {
      double result = 0.;
      for (std::size_t j = 0; j < status.size(); ++j)
        {
          const Eigen::Vector2d at_first = steady.forces.segment<2>(3 * j + 1),
                                now      = forces.segment<2>(3 * j + 1);
          if (steady.status[j] != ContactStatus::slip ||
              status[j] != ContactStatus::slip || !(at_first.norm() > 0.) ||
              !(now.norm() > 0.))
            continue;
          const double across = at_first[0] * now[1] - at_first[1] * now[0];
          result =
            std::max(result, std::atan2(std::abs(across), at_first.dot(now)));
        }
      return result;
    }

    /** Mean of `rms_forces` over the last @p n windows. */
    double
    mean_forces(const std::vector<MotionWindow> &windows, const unsigned int n)
    {
      double sum = 0.;
      for (std::size_t i = windows.size() - n; i < windows.size(); ++i)
        sum += windows[i].rms_forces / n;
      return sum;
    }
  } // namespace



  std::string
  fate_text(const MotionFate fate)
  {
    switch (fate)
      {
      case MotionFate::returns:
        return "returns";
      case MotionFate::squeals:
        return "squeals";
      case MotionFate::undecided:
        return "undecided";
      }
    unknown_choice("fate of a motion");
  }

  double
  FollowedMotion::lasting_forces() const
  {
    return windows.size() < n_judged ? 0. : mean_forces(windows, n_judged);
  }



  MotionFollower::MotionFollower(const PeriodMap     &m,
                                 const SteadySliding &s,
                                 const FateSettings  &how)
    : map(m)
    , steady(s)
    , settings(how)
    , rest(state_of(steady))
    , n_steps(rounded_count(settings.window, settings.step))
    , n_hold(static_cast<unsigned int>(
        std::max(2., std::ceil(settings.hold / window() - 1e-9))))
  {
  }

  double
  MotionFollower::window() const
  {
    return n_steps * settings.step;
  }



  Orbit
  MotionFollower::orbit(MotionPlace &place, const unsigned int n_windows) const
  {
    const unsigned int n = n_windows * n_steps;
    Orbit run = map.run_plainly(place.state, n * settings.step, n, place.past);
    place     = {run.end(), run.past_of(n), place.time + n * settings.step};
    return run;
  }

  MotionWindow
  MotionFollower::advance(MotionPlace &place) const
  {
    const ReducedContactModel &model = map.reduced_model();
    const Orbit                run   = orbit(place, 1);
    MotionWindow               result;
    result.time         = place.time;
    result.is_as_steady = true;
    double square       = 0.;
    for (unsigned int i = 0; i < n_steps; ++i)
      {
        square +=
          std::pow(energy_norm(model, run.states[i + 1], rest), 2) / n_steps;
        result.is_as_steady =
          result.is_as_steady && run.status[i] == steady.status;
        result.friction_turn = std::max(
          result.friction_turn,
          friction_turn_from(steady, run.states[i + 1].forces, run.status[i]));
      }
    result.amplitude          = std::sqrt(square);
    const PairForces  forces  = pair_forces(map, run);
    const JudgedRows  rows    = judged_rows(forces);
    const std::size_t loudest = loudest_pair(forces, rows);
    result.rms_normal         = rms_of(forces[loudest].row(rows[loudest]));
    result.judged_force       = moment_name(map, loudest, rows[loudest]);
    result.rms_forces         = rms_forces_of(forces);
    return result;
  }



  bool
  MotionFollower::has_returned(const std::vector<MotionWindow> &windows) const
  {
    return windows.size() >= n_hold &&
           std::all_of(windows.end() - n_hold,
                       windows.end(),
                       [](const auto &w) {
                         return w.is_as_steady &&
                                w.friction_turn <= linear_turn;
                       }) &&
           windows.back().amplitude < (windows.end() - n_hold)->amplitude;
  }

  bool
  MotionFollower::lasts(const std::vector<MotionWindow> &windows,
                        const double                     forces) const
  {
    return windows.size() >= n_hold &&
           std::all_of(
             windows.end() - n_hold, windows.end(), [&](const auto &w) {
               return !w.is_as_steady &&
                      std::abs(w.rms_forces - forces) <= same_forces * forces;
             });
  }

  FollowedMotion
  MotionFollower::follow(MotionPlace                  start,
                         const std::optional<double> &lasting) const
  {
    FollowedMotion result;
    result.n_judged   = n_hold;
    result.end        = std::move(start);
    const double last = result.end.time + settings.longest;
    while (result.fate == MotionFate::undecided && result.end.time < last)
      {
        result.windows.push_back(advance(result.end));
        if (has_returned(result.windows))
          result.fate = MotionFate::returns;
        else if (lasting && lasts(result.windows, *lasting))
          result.fate = MotionFate::squeals;
      }
    if (!lasting && result.fate == MotionFate::undecided &&
        lasts(result.windows, result.lasting_forces()))
      result.fate = MotionFate::squeals;
    return result;
  }



  MotionPlace
  struck_motion(const PeriodMap     &map,
                const SteadySliding &steady,
                const ModalForce    &unit,
                const double         impulse,
                const double         duration,
                const double         step)
  {
    const double          top = .5 * M_PI * impulse / duration;
    const unsigned int    n   = rounded_count(duration, step);
    TransientDrive::Force force{
      unit, [top, duration](const double time) {
        return time < duration ? top * std::sin(M_PI * time / duration) : 0.;
      }};
    const Orbit run =
      map.run_plainly(state_of(steady), duration, n, {}, &force);
    return {run.end(), run.past_of(n), duration};
  }
} // namespace squeal
