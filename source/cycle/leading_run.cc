// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/cycle/leading_run.h>
#include <squeal/cycle/orbit_forces.h>
#include <squeal/cycle/shooting.h>
#include <squeal/transient/spectrum.h>

#include <algorithm>
#include <cmath>

namespace squeal
{
  namespace
  {
    /** A motion has settled where it comes back as near as this, over the mean
     * distance, and where its forces change by no more than this share from
     * part to part. */
    constexpr double settled_return = 0.1, settled_forces = 0.02;
    /** What lasts has forces that differ by no more than this share. */
    constexpr double lasting_forces = 0.1;
    /** Parts that tell what a motion is. */
    constexpr std::size_t n_told = 3;
    /** A disturbance is this share of the velocities, and has grown clearly
     * where it is so many times as large: by some tens it also grows in motions
     * that settle, for a while. */
    constexpr double disturbed_share = 1e-5, clear_growth_of_run = 1000.;
    /** Of a motion that settles the nearest return falls below this share in
     * the second half of a time of some decays. */
    constexpr double stopped_nearing = 0.8;

    /** Distance, in the norm of energy_norm(), of @p state from the straight
     * line through two successive states of a motion. */
    double
    distance_beside(const ReducedContactModel &model,
                    const MotionState         &state,
                    const MotionState         &one_before,
                    const MotionState         &end)
    {
      // The square over the place on the line is a parabola.
      const auto square_at = [&](const double share) {
        const auto between = [&](Eigen::VectorXd MotionState::*x) {
          return Eigen::VectorXd(end.*x + share * (end.*x - one_before.*x));
        };
        return std::pow(energy_norm(model,
                                    state,
                                    {between(&MotionState::coordinates),
                                     between(&MotionState::velocities),
                                     between(&MotionState::forces)}),
                        2);
      };
      const double here = square_at(0.), ahead = square_at(1.),
                   back  = square_at(-1.);
      const double slope = .5 * (ahead - back),
                   bend  = .5 * (ahead + back) - here;
      return std::sqrt(
        std::max(0., bend > 0. ? here - .25 * slope * slope / bend : here));
    }
  } // namespace



  LeadingRun::LeadingRun(const PeriodMap &m,
                         MotionPlace      start,
                         const double     step,
                         const double     part,
                         const double     last,
                         const double     first)
    : map(m)
    , place(std::move(start))
    , dt(step)
    , n_steps(static_cast<unsigned int>(
        std::max(2., std::ceil(std::min(part, .5 * last) / step))))
    , longest(last)
    , shortest(first)
  {
  }

  bool
  LeadingRun::advance()
  {
    const double length = n_steps * dt;
    const Orbit run = map.run_plainly(place.state, length, n_steps, place.past);
    last_ends.push_back({place, run.states[n_steps - 1], run.end()});
    if (last_ends.size() > n_told)
      last_ends.erase(last_ends.begin());
    place = {run.end(), run.past_of(n_steps), place.time + length};
    time += length;
    last_forces.push_back(pair_forces(map, run));
    if (last_forces.size() > n_told)
      last_forces.erase(last_forces.begin());
    rms_forces.push_back(rms_forces_of(last_forces.back()));
    last_returns = recurrences(map.reduced_model(), run, shortest, length);
    nearest.push_back(nearest_return());
    return time + .5 * length < longest;
  }

  double
  LeadingRun::nearest_return() const
  {
    return last_returns.empty() ? 1. : last_returns.back().second;
  }



  bool
  LeadingRun::has_settled() const
  {
    const std::size_t n = rms_forces.size();
    return n > 1 && nearest_return() < settled_return &&
           std::abs(rms_forces[n - 1] - rms_forces[n - 2]) <=
             settled_forces * rms_forces[n - 1];
  }

  bool
  LeadingRun::lasts() const
  {
    if (rms_forces.size() < n_told)
      return false;
    double mean = 0.;
    for (auto r = rms_forces.end() - n_told; r != rms_forces.end(); ++r)
      mean += *r / n_told;
    return std::all_of(
      rms_forces.end() - n_told, rms_forces.end(), [&](const double r) {
        return std::abs(r - mean) <= lasting_forces * mean;
      });
  }

  bool
  LeadingRun::disturbance_grows() const
  {
    if (last_ends.size() < n_told)
      return false;
    const ReducedContactModel &model  = map.reduced_model();
    const double               length = n_steps * dt;
    MotionPlace                beside = last_ends.front().start;
    const MotionState          start  = beside.state;
    beside.state.velocities *= 1. + disturbed_share;
    const double first = energy_norm(model, beside.state, start);
    for (const PartEnds &part : last_ends)
      {
        const Orbit orbit =
          map.run_plainly(beside.state, length, n_steps, beside.past);
        beside = {orbit.end(), orbit.past_of(n_steps), beside.time + length};
        const double now =
          distance_beside(model, beside.state, part.one_before, part.end);
        if (now > clear_growth_of_run * first)
          return true;
      }
    return false;
  }

  bool
  LeadingRun::has_stopped_nearing() const
  {
    const std::size_t n = nearest.size();
    return n >= n_told &&
           nearest[n - 1] >= stopped_nearing * nearest[(n - 1) / 2];
  }



  PairForces
  LeadingRun::resultants() const
  {
    PairForces result(map.nodes_of_pairs().size());
    for (std::size_t p = 0; p < result.size(); ++p)
      {
        result[p].resize(last_forces.back()[p].rows(),
                         n_steps * last_forces.size());
        for (std::size_t i = 0; i < last_forces.size(); ++i)
          result[p].middleCols(i * n_steps, n_steps) = last_forces[i][p];
      }
    return result;
  }

  RunFigures
  LeadingRun::figures() const
  {
    return figures(last_forces.empty() ? JudgedRows()
                                       : judged_rows(last_forces.back()));
  }

  RunFigures
  LeadingRun::figures(const JudgedRows &rows) const
  {
    RunFigures result;
    result.time = time;
    if (last_forces.empty())
      return result;
    const PairForces forces = resultants();
    const double     lowest = 2. / (n_steps * dt), highest = .5 / dt;
    const Spectrum   spectrum = spectrum_of(forces, rows, dt);
    for (std::size_t p = 0; p < rows.size(); ++p)
      result.rms_of_pairs.push_back(rms_of(last_forces.back()[p].row(rows[p])));
    const std::size_t loudest = loudest_pair(last_forces.back(), rows);
    result.judged_force       = moment_name(map, loudest, rows[loudest]);
    result.rms_normal         = result.rms_of_pairs[loudest];
    result.line               = spectrum.peak(lowest, highest);
    result.frequency          = spectrum.fundamental(lowest, highest);
    if (result.frequency > 0.)
      result.repetition = repetition(
        signal_of(forces[loudest], rows[loudest]), dt, result.frequency);
    result.recurrence = nearest_return();
    result.lasts      = lasts();
    return result;
  }
} // namespace squeal
