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

    /** The steps of two neighbours, in the modes of @p last. */
    Tangent
    tangent_of(const PeriodMaps     &maps,
               const BranchPoint    &before,
               const BranchPoint    &last,
               const BranchSettings &s)
    {
      const ReducedContactModel &model = maps(last.parameter)->reduced_model();
      const MotionState a  = maps.carried(before.motion.orbit.states.front(),
                                         before.parameter,
                                         last.parameter),
                        &b = last.motion.orbit.states.front();
      const double size    = motion_size(model, last.motion.orbit);
      Tangent      t;
      t.period    = last.motion.period / before.motion.period - 1.;
      t.parameter = (last.parameter - before.parameter) / (s.upper - s.lower);
      t.length =
        std::hypot(energy_norm(model, a, b) / size, t.period, t.parameter);
      t.period /= t.length;
      t.parameter /= t.length;
      t.state = {(b.coordinates - a.coordinates) / t.length,
                 (b.velocities - a.velocities) / t.length,
                 (b.forces - a.forces) / t.length};
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



  std::optional<BranchPoint>
  correct_along(const PeriodMaps     &maps,
                const BranchPoint    &before,
                const BranchPoint    &last,
                const double          step,
                const BranchSettings &s)
  {
    auto         map   = maps(last.parameter);
    Tangent      t     = tangent_of(maps, before, last, s);
    const double size  = motion_size(map->reduced_model(), last.motion.orbit),
                 range = s.upper - s.lower;
    MotionState state  = last.motion.orbit.states.front();
    state.coordinates += step * t.state.coordinates;
    state.velocities += step * t.state.velocities;
    state.forces += step * t.state.forces;
    double      period = last.motion.period * (1. + step * t.period);
    BranchPoint x;
    x.parameter          = last.parameter + step * t.parameter * range;
    ContactPast past     = last.motion.orbit.past_of(s.shooting.n_steps);
    double      residual = 0.,
           modes_of = last.parameter; // whose modes the state is written in
    StepCorrections held;
    bool            is_held = false;
    for (unsigned int i = 0; i <= s.shooting.iterations; ++i)
      {
        map = maps.find(x.parameter);
        if (!map)
          return {};
        state    = maps.carried(state, modes_of, x.parameter);
        t.state  = maps.carried_difference(t.state, modes_of, x.parameter);
        held     = maps.carried(held, modes_of, x.parameter);
        modes_of = x.parameter;
        if (!try_orbit(*map,
                       state,
                       period,
                       s.shooting.n_steps,
                       past,
                       is_held ? &held : nullptr,
                       x.motion))
          return {};
        x.motion.iterations = i;
        x.motion.history.push_back(x.motion.residual);
        if (is_steady(*map, x.motion.orbit))
          return {};
        if (x.motion.residual <= s.shooting.tolerance)
          {
            x.motion.status = CycleStatus::converged;
            return x;
          }
        if (!is_held && i > 0 &&
            StatusChangeRule::holds(residual, x.motion.residual / residual))
          {
            held    = x.motion.orbit.corrections;
            is_held = true;
          }
        else if (i > 2 && x.motion.residual > residual)
          return {};
        residual                    = x.motion.residual;
        const std::vector<int> rows = map->closed_rows(x.motion.orbit);
        const ScaledMotion     scaled(map->reduced_model(), rows, period);
        Eigen::VectorXd        by_parameter;
        if (!change_with_parameter(maps, x, s, scaled, by_parameter))
          return {};
        Eigen::VectorXd row(by_parameter.size() + 2);
        row << scaled.pack(
                 t.state.coordinates, t.state.velocities, t.state.forces) /
                 (size * size),
          t.period, t.parameter;
        // What the tangent has at forces that do not count is left out.
        const Eigen::VectorXd change =
          PeriodEquations(*map,
                          x.motion,
                          scaled,
                          rows,
                          is_held ? StatusChanges::held
                                  : StatusChanges::located)
            .solve_with(by_parameter, row, 0.);
        const Eigen::Index n = by_parameter.size();
        if (!change.allFinite() ||
            std::abs(change[n]) > largest_branch_change ||
            std::abs(change[n + 1]) > largest_branch_change)
          return {};
        state = scaled.moved(state, change.head(n));
        period *= 1. + change[n];
        x.parameter += change[n + 1] * range;
        past = x.motion.orbit.past_of(s.shooting.n_steps);
      }
    return {};
  }
} // namespace squeal
