// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/cycle/orbit_forces.h>
#include <squeal/transient/spectrum.h>

namespace squeal
{
  namespace
  {
    /** A force that changes by less than this share of another is constant. */
    constexpr double constant_share = 1e-9;
  } // namespace



  Eigen::MatrixXd
  resultants_of(const Orbit &orbit)
  {
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero(3, orbit.n_steps());
    for (unsigned int i = 0; i < orbit.n_steps(); ++i)
      {
        const Eigen::VectorXd &f = orbit.states[i + 1].forces;
        for (Eigen::Index j = 0; j < f.size(); j += 3)
          result.col(i) += f.segment<3>(j);
      }
    return result;
  }



  OrbitLine
  line_of(const Orbit &orbit, const double lowest, const double highest)
  {
    const Eigen::MatrixXd f = resultants_of(orbit);
    const Eigen::VectorXd spread =
      (f.colwise() - f.rowwise().mean()).rowwise().norm();
    const Eigen::Index  row = spread[0] > constant_share * spread[1] ? 0 : 1;
    std::vector<double> signal(f.cols());
    for (Eigen::Index i = 0; i < f.cols(); ++i)
      signal[i] = f(row, i);
    OrbitLine result;
    result.frequency =
      power_spectrum(signal, orbit.step).fundamental(lowest, highest);
    if (result.frequency > 0.)
      result.repetition = repetition(signal, orbit.step, result.frequency);
    return result;
  }
} // namespace squeal
