// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_cycle_orbit_forces_h
#define squeal_cycle_orbit_forces_h

#include <squeal/cycle/period_map.h>
#include <squeal/transient/spectrum.h>

#include <vector>

namespace squeal
{
  /** Of each pair the sums of its nodal forces after every step, N: normal,
   * along and across the sliding, x steps. Sums over all pairs say little of a
   * motion: pads that move against each other cancel in them at odd harmonics.
   */
  using PairForces = std::vector<Eigen::MatrixXd>;

  PairForces pair_forces(const PeriodMap &map, const Orbit &orbit);

  /** The sums over all pairs. */
  Eigen::MatrixXd sum_of(const PairForces &forces);

  /** Root mean square about the mean. */
  double rms_of(const Eigen::VectorXd &x);

  /** The pair whose normal force has the largest rms; the first of equal ones.
   */
  std::size_t loudest_pair(const PairForces &forces);

  /** Mean squares about their means of the normal and the tangential force of a
   * pair, N^2. */
  Eigen::Vector2d variance_of(const Eigen::MatrixXd &forces);

  /** Root of those sums over all pairs, N. */
  double rms_forces_of(const PairForces &forces);

  /** Of row @p row of the forces of every pair, densities added up. */
  Spectrum spectrum_of(const PairForces  &forces,
                       const Eigen::Index row,
                       const double       step);

  /** Row @p row of @p forces. */
  std::vector<double> signal_of(const Eigen::MatrixXd &forces,
                                const Eigen::Index     row);

  /** The frequency of a motion by the line spectra of the normal forces of all
   * pairs, of the tangential ones where those are constant. */
  struct OrbitLine
  {
    double frequency  = 0.; /**< Hz; 0: there is no line */
    double repetition = 0.; /**< as repetition() of a signal, loudest pair */
  };

  /** Between @p lowest and @p highest, Hz; as Spectrum::fundamental(). */
  OrbitLine line_of(const PeriodMap &map,
                    const Orbit     &orbit,
                    const double     lowest,
                    const double     highest);
} // namespace squeal

#endif
