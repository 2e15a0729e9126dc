// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/cycle/branch_step.h>
#include <squeal/cycle/period_equations.h>

#include <algorithm>
#include <cmath>

namespace squeal
{
  namespace
  {
    /** Of the range, of the parameter's difference quotient. Modes that are
     * computed anew are good to fewer digits than friction that is exact. */
    constexpr double small_change = 1e-5, small_change_of_modes = 1e-4;
    /** Changes of period and parameter, over itself and its range, beyond
     * which an iteration is no longer near the branch. */
    constexpr double largest_branch_change = 0.3;

    /** Where a branch goes, per unit of its length. */
    struct Tangent
    {
      MotionState state;
      double      period    = 0.; /**< in shares of itself */
      double      parameter = 0.; /**< in shares of the range */
      double      length    = 0.; /**< of the step that it was told from */
    };

    /** <x, y> of the norm of the energy. */
    double
    energy_product(const ReducedContactModel &model,
                   const MotionState         &x,
                   const MotionState         &y)
    {
      return x.velocities.dot(y.velocities) +
             model.omega_squared.dot(
               x.coordinates.cwiseProduct(y.coordinates)) +
             x.forces.dot(model.flexibility * y.forces);
    }

    /** @p change of the start of @p orbit without what moves it along the
     * motion: where in its period a motion starts is no part of the way along a
     * branch. A tangent would hand such a shift on from step to step, which
     * then grows until the branch goes back along itself. */
    MotionState
    across_motion(const PeriodMap &map, const Orbit &orbit, MotionState change)
    {
      const MotionState rate = rate_of_motion(map, orbit);
      // Forces have no part in the product, as in the condition of shooting.
      const MotionState without_forces{
        rate.coordinates,
        rate.velocities,
        Eigen::VectorXd::Zero(rate.forces.size())};
      const ReducedContactModel &model = map.reduced_model();
      const double time = energy_product(model, change, without_forces) /
                          energy_product(model, without_forces, without_forces);
      change.coordinates -= time * rate.coordinates;
      change.velocities -= time * rate.velocities;
      change.forces -= time * rate.forces;
      return change;
    }

    /** The steps of two neighbours, in the modes of @p last. */
    Tangent
    tangent_of(const PeriodMaps     &maps,
               const BranchPoint    &before,
               const BranchPoint    &last,
               const BranchSettings &s)
    {
      const auto                 map   = maps(last.parameter);
      const ReducedContactModel &model = map->reduced_model();
      const MotionState a  = maps.carried(before.motion.orbit.states.front(),
                                         before.parameter,
                                         last.parameter),
                        &b = last.motion.orbit.states.front();
      const MotionState change = across_motion(*map,
                                               last.motion.orbit,
                                               {b.coordinates - a.coordinates,
                                                b.velocities - a.velocities,
                                                b.forces - a.forces});
      const double      size   = motion_size(model, last.motion.orbit);
      Tangent           t;
      t.period    = last.motion.period / before.motion.period - 1.;
      t.parameter = (last.parameter - before.parameter) / (s.upper - s.lower);
      t.length =
        std::hypot(std::sqrt(energy_product(model, change, change)) / size,
                   t.period,
                   t.parameter);
      t.period /= t.length;
      t.parameter /= t.length;
      t.state = {change.coordinates / t.length,
                 change.velocities / t.length,
                 change.forces / t.length};
      return t;
    }

    /** What the end of the period of @p x moves by when the parameter does, by
     * the range. False where a step has no solution. */
    bool
    change_with_parameter(const PeriodMaps     &maps,
                          const BranchPoint    &x,
                          const BranchSettings &s,
                          const ScaledMotion   &scaled,
                          Eigen::VectorXd      &result)
    {
      const double share =
                     maps.share_modes() ? small_change : small_change_of_modes,
                   beside  = x.parameter + share * (s.upper - s.lower);
      const auto     map   = maps.find(beside);
      const Orbit   &orbit = x.motion.orbit;
      PeriodicMotion moved;
      if (!map)
        return false;
      // Held corrections leave the quotient smooth.
      const StepCorrections held =
        maps.carried(orbit.corrections, x.parameter, beside);
      if (!try_orbit(*map,
                     maps.carried(orbit.states.front(), x.parameter, beside),
                     x.motion.period,
                     orbit.n_steps(),
                     orbit.past,
                     &held,
                     moved))
        return false;
      result =
        scaled.difference(maps.carried(moved.orbit.end(), beside, x.parameter),
                          orbit.end()) /
        share;
      return true;
    }
  } // namespace



  double
  branch_distance(const PeriodMaps     &maps,
                  const BranchPoint    &before,
                  const BranchPoint    &last,
                  const BranchSettings &settings)
  {
    return tangent_of(maps, before, last, settings).length;
  }

  double
  branch_turn(const PeriodMaps     &maps,
              const BranchPoint    &before,
              const BranchPoint    &last,
              const BranchPoint    &next,
              const BranchSettings &settings)
  {
    Tangent       x = tangent_of(maps, before, last, settings);
    const Tangent y = tangent_of(maps, last, next, settings);
    x.state = maps.carried_difference(x.state, last.parameter, next.parameter);
    const ReducedContactModel &model = maps(next.parameter)->reduced_model();
    const double               size  = motion_size(model, next.motion.orbit);
    const auto product               = [&](const Tangent &a, const Tangent &b) {
      return energy_product(model, a.state, b.state) / (size * size) +
             a.period * b.period + a.parameter * b.parameter;
    };
    const double cosine =
      product(x, y) / std::sqrt(product(x, x) * product(y, y));
    return std::acos(std::clamp(cosine, -1., 1.));
  }



  namespace
  {
    /** Where the tangent leads to, on the way to the branch. */
    class Corrector
    {
    public:
      Corrector(const PeriodMaps     &m,
                const BranchPoint    &before,
                const BranchPoint    &last,
                const double          step,
                const BranchSettings &s)
        : maps(m)
        , settings(s)
        , range(s.upper - s.lower)
        , tangent(tangent_of(m, before, last, s))
        , size(
            motion_size(m(last.parameter)->reduced_model(), last.motion.orbit))
        , state(last.motion.orbit.states.front())
        , period(last.motion.period * (1. + step * tangent.period))
        , past(last.motion.orbit.past_of(s.shooting.n_steps))
        , modes_of(last.parameter)
      {
        state.coordinates += step * tangent.state.coordinates;
        state.velocities += step * tangent.state.velocities;
        state.forces += step * tangent.state.forces;
        point.parameter = last.parameter + step * tangent.parameter * range;
      }

      /** Newton's method, of the motion at the parameter that the tangent has
       * led to where @p is_fixed, else of both. */
      std::optional<BranchPoint>
      solve(const bool is_fixed)
      {
        double residual = 0.;
        for (unsigned int i = 0; i <= settings.shooting.iterations; ++i)
          {
            if (!run_period(i))
              return {};
            const double now = point.motion.residual;
            if (now <= settings.shooting.tolerance)
              {
                if (is_held && !keeps_when_located())
                  return {};
                point.motion.status = CycleStatus::converged;
                return point;
              }
            if (!is_held && i > 0 &&
                StatusChangeRule::holds(residual, now / residual))
              {
                held    = point.motion.orbit.corrections;
                is_held = true;
              }
            else if (i > 2 && now > residual)
              return {};
            residual = now;
            if (!(is_fixed ? move_motion() : move_along()))
              return {};
            past = point.motion.orbit.past_of(settings.shooting.n_steps);
          }
        return {};
      }

    private:
      /** Of the motion at hand, in the modes at its parameter; false where
       * there is none that vibrates. */
      bool
      run_period(const unsigned int iteration)
      {
        map = maps.find(point.parameter);
        if (!map)
          return false;
        state = maps.carried(state, modes_of, point.parameter);
        tangent.state =
          maps.carried_difference(tangent.state, modes_of, point.parameter);
        held     = maps.carried(held, modes_of, point.parameter);
        modes_of = point.parameter;
        if (!try_orbit(*map,
                       state,
                       period,
                       settings.shooting.n_steps,
                       past,
                       is_held ? &held : nullptr,
                       point.motion))
          return false;
        point.motion.iterations = iteration;
        point.motion.history.push_back(point.motion.residual);
        return !is_steady(*map, point.motion.orbit);
      }

      /** Whether the motion, whose changes of status are held, is about
       * periodic with those located on it, too. */
      bool
      keeps_when_located()
      {
        const auto located = located_anew(*map, point.motion);
        if (!located)
          return false;
        point.motion.left_open.residual = located->residual;
        return located->residual < settings.shooting.largest_left_open;
      }

      PeriodEquations
      equations(const ScaledMotion &scaled, const std::vector<int> &rows) const
      {
        return {*map,
                point.motion,
                scaled,
                rows,
                is_held ? StatusChanges::held : StatusChanges::located};
      }

      bool
      move_motion()
      {
        const std::vector<int> rows = map->closed_rows(point.motion.orbit);
        const ScaledMotion     scaled(map->reduced_model(), rows, period);
        return move(
          scaled,
          equations(scaled, rows)
            .solve(scaled.difference(point.motion.orbit.end(), state)));
      }

      /** At right angles to the tangent. */
      bool
      move_along()
      {
        const std::vector<int> rows = map->closed_rows(point.motion.orbit);
        const ScaledMotion     scaled(map->reduced_model(), rows, period);
        Eigen::VectorXd        by_parameter;
        if (!change_with_parameter(maps, point, settings, scaled, by_parameter))
          return false;
        const Eigen::Index n = by_parameter.size();
        Eigen::VectorXd    row(n + 2);
        // What the tangent has at forces that do not count is left out.
        row << scaled.pack(tangent.state.coordinates,
                           tangent.state.velocities,
                           tangent.state.forces) /
                 (size * size),
          tangent.period, tangent.parameter;
        const Eigen::VectorXd change =
          equations(scaled, rows).solve_with(by_parameter, row, 0.);
        if (!(std::abs(change[n + 1]) <= largest_branch_change))
          return false;
        point.parameter += change[n + 1] * range;
        return move(scaled, change.head(n + 1));
      }

      /** The state and the period by @p change; false where that leads away. */
      bool
      move(const ScaledMotion &scaled, const Eigen::VectorXd &change)
      {
        const Eigen::Index n = change.size() - 1;
        if (!change.allFinite() || std::abs(change[n]) > largest_branch_change)
          return false;
        state = scaled.moved(state, change.head(n));
        period *= 1. + change[n];
        return true;
      }

      const PeriodMaps     &maps;
      const BranchSettings &settings;
      const double          range;
      Tangent               tangent;
      const double          size;
      MotionState           state;
      double                period;
      ContactPast           past;
      double          modes_of; /**< whose modes the state is written in */
      BranchPoint     point;
      PeriodMaps::Map map;
      StepCorrections held;
      bool            is_held = false;
    };

    /** Share of the parameter in a step's tangent from which on the motion is
     * sought at a fixed parameter first where every parameter takes a model of
     * its own: that needs one, Newton's method for both two an iteration. */
    constexpr double steep = 0.3;
  } // namespace



  std::optional<BranchPoint>
  correct_along(const PeriodMaps     &maps,
                const BranchPoint    &before,
                const BranchPoint    &last,
                const double          step,
                const BranchSettings &s)
  {
    if (!maps.share_modes() &&
        std::abs(tangent_of(maps, before, last, s).parameter) > steep)
      {
        auto found = Corrector(maps, before, last, step, s).solve(true);
        // Far from where the tangent leads is another branch.
        if (found && branch_distance(maps, last, *found, s) < 2. * step)
          return found;
      }
    return Corrector(maps, before, last, step, s).solve(false);
  }
} // namespace squeal
