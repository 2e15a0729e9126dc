// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/cycle/orbit_forces.h>

#include <cmath>

namespace squeal
{
  namespace
  {
    /** A force that changes by less than this share of another is constant. */
    constexpr double constant_share = 1e-9;
    /** Pairs whose rms differ by less than this share are equally loud. */
    constexpr double equal_share = 1e-6;

    /** Mean squares of all rows about their means, added up. */
    double
    variance_of(const Eigen::MatrixXd &f)
    {
      return (f.colwise() - f.rowwise().mean()).squaredNorm() / f.cols();
    }
  } // namespace



  PairForces
  pair_forces(const PeriodMap &map, const Orbit &orbit)
  {
    PairForces   result;
    Eigen::Index first = 0;
    for (const unsigned int n_nodes : map.nodes_of_pairs())
      {
        const std::size_t pair = result.size();
        result.push_back(
          Eigen::MatrixXd::Zero(moment_row + 2, orbit.n_steps()));
        for (unsigned int i = 0; i < orbit.n_steps(); ++i)
          {
            const Eigen::VectorXd &f = orbit.states[i + 1].forces;
            for (Eigen::Index j = first; j < first + 3 * n_nodes; j += 3)
              result.back().col(i).head<3>() += f.segment<3>(j);
            if (pair < map.moments_of_pairs().size())
              result.back().col(i).tail<2>() =
                map.moments_of_pairs()[pair].rows *
                f.segment(first, 3 * n_nodes);
          }
        first += 3 * n_nodes;
      }
    return result;
  }

  Eigen::Index
  judged_row(const Eigen::MatrixXd &forces)
  {
    const auto rms = [&](const Eigen::Index row) {
      return rms_of(forces.row(row));
    };
    const double       least = least_vibration * forces.row(normal_row).mean();
    const Eigen::Index moment =
      moment_row + (rms(moment_row + 1) > (1. + equal_share) * rms(moment_row));
    // Pure stick-slip leaves the normal force alone.
    const bool is_steady =
      !(rms(normal_row) > least) && rms(tangential_row) > least;
    const double force = rms(is_steady ? tangential_row : normal_row);
    return least > 0. && rms(moment) > least && rms(moment) > far_louder * force
             ? moment
             : normal_row;
  }

  JudgedRows
  judged_rows(const PairForces &forces)
  {
    JudgedRows result;
    for (const Eigen::MatrixXd &f : forces)
      result.push_back(judged_row(f));
    return result;
  }

  std::string
  moment_name(const PeriodMap   &map,
              const std::size_t  pair,
              const Eigen::Index row)
  {
    return row < moment_row
             ? ""
             : map.moments_of_pairs().at(pair).names[row - moment_row];
  }

  Eigen::MatrixXd
  sum_of(const PairForces &forces)
  {
    Eigen::MatrixXd result = forces.front();
    for (std::size_t p = 1; p < forces.size(); ++p)
      result += forces[p];
    return result;
  }

  double
  rms_of(const Eigen::VectorXd &x)
  {
    return std::sqrt((x.array() - x.mean()).square().mean());
  }

  std::size_t
  loudest_pair(const PairForces &forces, const JudgedRows &rows)
  {
    std::size_t result = 0;
    for (std::size_t p = 1; p < forces.size(); ++p)
      if (rms_of(forces[p].row(rows[p])) >
          (1. + equal_share) * rms_of(forces[result].row(rows[result])))
        result = p;
    return result;
  }

  double
  rms_forces_of(const PairForces &forces)
  {
    double sum = 0.;
    for (const Eigen::MatrixXd &f : forces)
      {
        sum += variance_of(f.topRows<2>());
        if (judged_row(f) >= moment_row)
          sum += variance_of(f.bottomRows<2>());
      }
    return std::sqrt(sum);
  }



  std::vector<double>
  signal_of(const Eigen::MatrixXd &forces, const Eigen::Index row)
  {
    std::vector<double> result(forces.cols());
    for (Eigen::Index i = 0; i < forces.cols(); ++i)
      result[i] = forces(row, i);
    return result;
  }

  Spectrum
  spectrum_of(const PairForces &forces,
              const JudgedRows &rows,
              const double      step)
  {
    Spectrum result =
      power_spectrum(signal_of(forces.front(), rows.front()), step);
    for (std::size_t p = 1; p < forces.size(); ++p)
      {
        const Spectrum next =
          power_spectrum(signal_of(forces[p], rows[p]), step);
        for (std::size_t k = 0; k < result.density.size(); ++k)
          result.density[k] += next.density[k];
      }
    return result;
  }



  OrbitLine
  line_of(const PeriodMap &map,
          const Orbit     &orbit,
          const double     lowest,
          const double     highest)
  {
    const PairForces forces = pair_forces(map, orbit);
    JudgedRows       rows   = judged_rows(forces);
    double           judged = 0., along = 0.;
    for (std::size_t p = 0; p < forces.size(); ++p)
      {
        judged += rms_of(forces[p].row(rows[p]));
        along += rms_of(forces[p].row(tangential_row));
      }
    const std::size_t loudest = loudest_pair(forces, rows);
    if (!(judged > constant_share * along))
      rows.assign(forces.size(), tangential_row);
    OrbitLine result;
    result.frequency =
      spectrum_of(forces, rows, orbit.step).fundamental(lowest, highest);
    if (result.frequency > 0.)
      result.repetition = repetition(signal_of(forces[loudest], rows[loudest]),
                                     orbit.step,
                                     result.frequency);
    return result;
  }
} // namespace squeal
