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
  } // namespace



  PairForces
  pair_forces(const PeriodMap &map, const Orbit &orbit)
  {
    PairForces   result;
    Eigen::Index first = 0;
    for (const unsigned int n_nodes : map.nodes_of_pairs())
      {
        result.push_back(Eigen::MatrixXd::Zero(3, orbit.n_steps()));
        for (unsigned int i = 0; i < orbit.n_steps(); ++i)
          {
            const Eigen::VectorXd &f = orbit.states[i + 1].forces;
            for (Eigen::Index j = first; j < first + 3 * n_nodes; j += 3)
              result.back().col(i) += f.segment<3>(j);
          }
        first += 3 * n_nodes;
      }
    return result;
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
  loudest_pair(const PairForces &forces)
  {
    std::size_t result = 0;
    for (std::size_t p = 1; p < forces.size(); ++p)
      if (rms_of(forces[p].row(0)) >
          (1. + equal_share) * rms_of(forces[result].row(0)))
        result = p;
    return result;
  }

  Eigen::Vector2d
  variance_of(const Eigen::MatrixXd &forces)
  {
    const Eigen::MatrixXd f = forces.topRows<2>();
    return (f.colwise() - f.rowwise().mean()).rowwise().squaredNorm() /
           forces.cols();
  }

  double
  rms_forces_of(const PairForces &forces)
  {
    double sum = 0.;
    for (const Eigen::MatrixXd &f : forces)
      sum += variance_of(f).sum();
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
  spectrum_of(const PairForces  &forces,
              const Eigen::Index row,
              const double       step)
  {
    Spectrum result = power_spectrum(signal_of(forces.front(), row), step);
    for (std::size_t p = 1; p < forces.size(); ++p)
      {
        const Spectrum next = power_spectrum(signal_of(forces[p], row), step);
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
    Eigen::Vector2d  spread = Eigen::Vector2d::Zero();
    for (const Eigen::MatrixXd &f : forces)
      spread += (f.colwise() - f.rowwise().mean()).rowwise().norm().head<2>();
    const Eigen::Index row = spread[0] > constant_share * spread[1] ? 0 : 1;
    OrbitLine          result;
    result.frequency =
      spectrum_of(forces, row, orbit.step).fundamental(lowest, highest);
    if (result.frequency > 0.)
      result.repetition =
        repetition(signal_of(forces[loudest_pair(forces)], row),
                   orbit.step,
                   result.frequency);
    return result;
  }
} // namespace squeal
