// SPDX-License-Identifier: LGPL-2.1-or-later

// What a periodic motion does at the contacts.

#include <squeal/cycle/cycle_figures.h>
#include <squeal/transient/modal_step.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <iterator>

namespace squeal
{
  namespace
  {
    /** Of the rms: what harmonics of a longer period leave of a motion that
     * repeats itself within it; and how often it may. */
    constexpr double       nothing          = 1e-3;
    constexpr unsigned int most_repetitions = 8;

    /** |a_k| of x = mean + Re sum a_k e^{i k omega t}. */
    std::vector<double>
    amplitudes_of(const Eigen::VectorXd &x)
    {
      const Eigen::Index  n = x.size();
      std::vector<double> result;
      for (Eigen::Index k = 1; 2 * k < n; ++k)
        {
          std::complex<double> sum = 0.;
          for (Eigen::Index i = 0; i < n; ++i)
            sum +=
              x[i] * std::polar(2. / n, -2. * M_PI * double(k * i % n) / n);
          result.push_back(std::abs(sum));
        }
      return result;
    }

    /** Depth of the nodes in the middle of the steps, over all. */
    double
    penetration_of(const ReducedContactModel &model, const Orbit &orbit)
    {
      const ModalStep half(model, .5 * orbit.step);
      double          result = 0.;
      for (unsigned int i = 0; i < orbit.n_steps(); ++i)
        {
          const MotionState    &a = orbit.states[i], &b = orbit.states[i + 1];
          const Eigen::VectorXd lambda = .5 * (a.forces + b.forces);
          const auto            modal  = [&](const Eigen::VectorXd &f) {
            return Eigen::VectorXd(model.load -
                                   model.participation.transpose() * f);
          };
          const Eigen::VectorXd q =
            half.q_q * a.coordinates + half.q_v * a.velocities +
            half.q_f0 * modal(a.forces) + half.q_f1 * modal(lambda);
          const Eigen::VectorXd u = model.participation * q +
                                    model.load_motion -
                                    model.flexibility * lambda;
          for (unsigned int j = 0; j < model.n_nodes(); ++j)
            result = std::max(result, u[3 * j] - model.initial_gap[j]);
        }
      return result;
    }

    /** Judged by row @p judged. */
    ForceFigures
    figures_of_pair(const Eigen::MatrixXd &resultants,
                    const Eigen::Index     judged)
    {
      ForceFigures          f;
      const Eigen::VectorXd normal = resultants.row(normal_row),
                            along  = resultants.row(tangential_row);
      f.resultants                 = resultants;
      f.judged                     = judged;
      f.mean_normal                = normal.mean();
      f.rms_of_sum                 = rms_of(normal);
      f.rms_normal                 = rms_of(resultants.row(judged));
      f.min_normal                 = normal.minCoeff();
      f.max_normal                 = normal.maxCoeff();
      f.mean_tangential            = along.mean();
      f.rms_tangential             = rms_of(along);
      f.normal_harmonics           = amplitudes_of(resultants.row(judged));
      for (const Eigen::Index i : {0, 1})
        if (const Eigen::VectorXd moment = resultants.row(moment_row + i);
            !moment.isZero(0.))
          {
            f.rms_moments[i]      = rms_of(moment);
            f.moment_harmonics[i] = amplitudes_of(moment);
          }
      f.tangential_harmonics = amplitudes_of(along);
      f.largest_harmonic =
        1 + std::distance(f.normal_harmonics.begin(),
                          std::max_element(f.normal_harmonics.begin(),
                                           f.normal_harmonics.end()));
      return f;
    }

    /** Whether no harmonics but multiples of @p times count. */
    bool
    is_repeated(const std::vector<double> &harmonics,
                const double               rms,
                const unsigned int         times)
    {
      double sum = 0.;
      for (std::size_t k = 1; k <= harmonics.size(); ++k)
        if (k % times != 0)
          sum += .5 * harmonics[k - 1] * harmonics[k - 1];
      return std::sqrt(sum) <= nothing * rms;
    }

    /** The same of both forces and both moments of a pair: moments that are
     * small beside its forces say nothing. */
    bool
    is_repeated(const ForceFigures &pair, const unsigned int times)
    {
      for (const unsigned int i : {0, 1})
        if (!is_repeated(pair.moment_harmonics[i],
                         std::max(pair.rms_moments[i], pair.rms_normal),
                         times))
          return false;
      return is_repeated(pair.normal_harmonics, pair.rms_normal, times) &&
             is_repeated(pair.tangential_harmonics, pair.rms_tangential, times);
    }
  } // namespace



  double
  ForceFigures::beyond(const unsigned int n) const
  {
    double sum = 0.;
    for (std::size_t k = n; k < normal_harmonics.size(); ++k)
      sum += .5 * normal_harmonics[k] * normal_harmonics[k];
    return std::sqrt(sum) / rms_normal;
  }

  CycleFigures
  cycle_figures(const PeriodMap      &map,
                const PeriodicMotion &motion,
                const CycleFigures   *like)
  {
    const ReducedContactModel &model  = map.reduced_model();
    const Orbit               &orbit  = motion.orbit;
    const unsigned int         n      = orbit.n_steps();
    const PairForces           forces = pair_forces(map, orbit);
    const JudgedRows rows = like ? like->judged_rows() : judged_rows(forces);
    CycleFigures     f;
    for (std::size_t p = 0; p < forces.size(); ++p)
      {
        f.pairs.push_back(figures_of_pair(forces[p], rows[p]));
        f.pairs.back().judged_force = moment_name(map, p, rows[p]);
      }
    f.loudest                      = loudest_pair(forces, rows);
    static_cast<ForceFigures &>(f) = f.pairs[f.loudest];
    if (f.pairs.size() == 1)
      f.pairs.clear();
    f.rms_together = rms_of(sum_of(forces).row(normal_row));
    f.frequency    = 1. / motion.period;
    std::vector<bool> opens(model.n_nodes()), closes(model.n_nodes()),
      sticks(model.n_nodes());
    Eigen::VectorXd lowest = orbit.motions[1], highest = lowest;
    for (unsigned int i = 0; i < n; ++i)
      {
        for (unsigned int j = 0; j < model.n_nodes(); ++j)
          {
            const bool is_open = orbit.status[i][j] == ContactStatus::open;
            opens[j]           = opens[j] || is_open;
            closes[j]          = closes[j] || !is_open;
            sticks[j] = sticks[j] || orbit.status[i][j] == ContactStatus::stick;
          }
        lowest  = lowest.cwiseMin(orbit.motions[i + 1]);
        highest = highest.cwiseMax(orbit.motions[i + 1]);
      }
    for (unsigned int j = 0; j < model.n_nodes(); ++j)
      f.gap_range = std::max(f.gap_range, highest[3 * j] - lowest[3 * j]);
    f.penetration = penetration_of(model, orbit);
    // What never touches does not open.
    for (unsigned int j = 0; j < model.n_nodes(); ++j)
      f.n_opening += opens[j] && closes[j];
    f.n_sticking = std::count(sticks.begin(), sticks.end(), true);
    return f;
  }



  std::vector<const ForceFigures *>
  CycleFigures::all() const
  {
    if (pairs.empty())
      return {this};
    std::vector<const ForceFigures *> result;
    for (const ForceFigures &pair : pairs)
      result.push_back(&pair);
    return result;
  }

  std::vector<double>
  CycleFigures::rms_of_pairs() const
  {
    std::vector<double> result;
    for (const ForceFigures *pair : all())
      result.push_back(pair->rms_normal);
    return result;
  }

  JudgedRows
  CycleFigures::judged_rows() const
  {
    JudgedRows result;
    for (const ForceFigures *pair : all())
      result.push_back(pair->judged);
    return result;
  }

  std::vector<double>
  CycleFigures::moments_of_pairs() const
  {
    std::vector<double> result;
    for (const ForceFigures *pair : all())
      result.push_back(std::hypot(pair->rms_moments[0], pair->rms_moments[1]));
    return result;
  }

  unsigned int
  CycleFigures::repetitions() const
  {
    for (unsigned int times = most_repetitions; times > 1; --times)
      if (normal_harmonics.size() >= 2 * times && is_repeated(*this, times) &&
          std::all_of(pairs.begin(), pairs.end(), [&](const auto &pair) {
            return is_repeated(pair, times);
          }))
        return times;
    return 1;
  }
} // namespace squeal
