// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_cycle_cycle_figures_h
#define squeal_cycle_cycle_figures_h

#include <squeal/cycle/shooting.h>

#include <vector>

namespace squeal
{
  /** Resultants of a contact pair over a period. */
  struct ForceFigures
  {
    Eigen::MatrixXd resultants; /**< sums of the nodal forces, N: normal, along
                                   and across the sliding, x steps */
    double mean_normal = 0., rms_normal = 0., min_normal = 0., max_normal = 0.;
    double mean_tangential = 0., rms_tangential = 0.;
    /** Of the normal and the tangential resultant, N: x = Re sum a_k e^{i k
     * omega t}, k from 1 to half the steps. */
    std::vector<double> normal_harmonics, tangential_harmonics;
    unsigned int        largest_harmonic = 0; /**< of the normal resultant */
    /** Root of the power of the normal resultant beyond @p n harmonics, over
     * its rms. */
    double beyond(const unsigned int n) const;
  };

  /** What a periodic motion does at the contacts: the resultants of the pair
   * whose normal force has the largest rms. */
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

    /** Of the normal resultant of every pair, N. */
    std::vector<double> rms_of_pairs() const;
    /** How many times the shortest period of the resultants the period is: no
     * other harmonics of any pair but multiples of that have more than a
     * thousandth of the rms. */
    unsigned int repetitions() const;
  };

  CycleFigures cycle_figures(const PeriodMap      &map,
                             const PeriodicMotion &motion);
} // namespace squeal

#endif
