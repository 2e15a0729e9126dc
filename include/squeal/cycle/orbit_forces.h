// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_cycle_orbit_forces_h
#define squeal_cycle_orbit_forces_h

#include <squeal/cycle/period_map.h>
#include <squeal/transient/spectrum.h>

#include <string>
#include <vector>

namespace squeal
{
  /** Of each pair the sums of its nodal forces after every step, N: normal,
   * along and across the sliding, and both of its PressureMoments (0 where the
   * map has none), x steps. Sums over all pairs say little of a motion: pads
   * that move against each other cancel in them at odd harmonics. In the plain
   * sum of one pair a wobble that goes round it cancels.
   */
  using PairForces = std::vector<Eigen::MatrixXd>;

  /** Rows of the forces of a pair. */
  constexpr Eigen::Index normal_row = 0, tangential_row = 1, moment_row = 3;

  /** The row whose vibration is that of a pair: of the normal force, or of the
   * larger one of its moments where that vibrates by far more (far_louder), as
   * in transients. */
  Eigen::Index judged_row(const Eigen::MatrixXd &forces);

  /** Of each pair. */
  using JudgedRows = std::vector<Eigen::Index>;

  JudgedRows judged_rows(const PairForces &forces);

  /** What the moment in @p row of pair number @p pair is called; empty for a
   * row that is none. */
  std::string moment_name(const PeriodMap   &map,
                          const std::size_t  pair,
                          const Eigen::Index row);

  PairForces pair_forces(const PeriodMap &map, const Orbit &orbit);

  /** The sums over all pairs, whose moments have no meaning. */
  Eigen::MatrixXd sum_of(const PairForces &forces);

  /** Root mean square about the mean. */
  double rms_of(const Eigen::VectorXd &x);

  /** The pair whose force in its row of @p rows has the largest rms; the first
   * of equal ones. */
  std::size_t loudest_pair(const PairForces &forces, const JudgedRows &rows);

  /** Root of the mean squares about their means of the normal and the
   * tangential force of all pairs, and of both moments of those that are judged
   * by one, N. */
  double rms_forces_of(const PairForces &forces);

  /** Of the row of each pair in @p rows, densities added up. */
  Spectrum spectrum_of(const PairForces &forces,
                       const JudgedRows &rows,
                       const double      step);

  /** Row @p row of @p forces. */
  std::vector<double> signal_of(const Eigen::MatrixXd &forces,
                                const Eigen::Index     row);

  /** The frequency of a motion by the line spectra of the judged_row() of all
   * pairs, of the tangential forces where those are constant. */
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
