// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_cycle_cycle_figures_h
#define squeal_cycle_cycle_figures_h

#include <squeal/cycle/orbit_forces.h>
#include <squeal/cycle/shooting.h>

#include <array>
#include <string>
#include <vector>

namespace squeal
{
  /** Resultants of a contact pair over a period. Where a moment of the normal
   * forces is judged, rms and harmonics of the normal force are those of it. */
  struct ForceFigures
  {
    Eigen::MatrixXd resultants;          /**< N, see PairForces */
    Eigen::Index    judged = normal_row; /**< see judged_row() */
    std::string     judged_force; /**< that moment; empty: there is none */
    double mean_normal = 0., rms_normal = 0., min_normal = 0., max_normal = 0.;
    double mean_tangential = 0., rms_tangential = 0.;
    /** Of the normal and the tangential resultant, N: x = Re sum a_k e^{i k
     * omega t}, k from 1 to half the steps. */
    std::vector<double> normal_harmonics, tangential_harmonics;
    unsigned int        largest_harmonic = 0; /**< of the normal resultant */
    /** Of the normal resultant, whatever is judged, N. */
    double rms_of_sum = 0.;
    /** Of both moments, N, as `rms_normal` and `normal_harmonics`. */
    std::array<double, 2>              rms_moments{};
    std::array<std::vector<double>, 2> moment_harmonics;
    /** Root of the power of the normal resultant beyond @p n harmonics, over
     * its rms. */
    double beyond(const unsigned int n) const;
  };

  /** What a periodic motion does at the contacts: the resultants of the pair
   * whose normal force, or moment that is judged, has the largest rms. */
  struct CycleFigures : ForceFigures
  {
    double frequency = 0.; /**< Hz */
    /** Depth, m, that a node reaches in the middle of a step, and the largest
     * change of a gap over the period. */
    double       penetration = 0., gap_range = 0.;
    unsigned int n_opening = 0, n_sticking = 0; /**< nodes that do so */

    std::vector<ForceFigures> pairs; /**< each of several; empty: one pair */
    unsigned int              loudest = 0; /**< the one that is above */
    double rms_together = 0.; /**< of the sum of all normal resultants, N */

    /** `rms_normal` of every pair, N. */
    std::vector<double> rms_of_pairs() const;
    /** What every pair is judged by. */
    JudgedRows judged_rows() const;
    /** The root of the squares of both moments of every pair, N, which does not
     * hang on the axes. */
    std::vector<double> moments_of_pairs() const;
    /** How many times the shortest period of the resultants and the moments the
     * period is: no other harmonics of any pair but multiples of that have more
     * than a thousandth of the rms. */
    unsigned int repetitions() const;

  private:
    /** Each of several pairs, or the only one. */
    std::vector<const ForceFigures *> all() const;
  };

  /** @p like: of a motion whose pairs are judged by the same forces as those of
   * this one, so that differences tell an error; null: there is none. */
  CycleFigures cycle_figures(const PeriodMap      &map,
                             const PeriodicMotion &motion,
                             const CycleFigures   *like = nullptr);
} // namespace squeal

#endif
