// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_analyses_transient_force_statistics_h
#define squeal_analyses_transient_force_statistics_h

#include <squeal/transient/slow_part.h>

#include <vector>

namespace squeal
{
  /**
   * Statistics of the contact forces after every step of a stretch of a
   * transient. Steps are equally long and weigh alike. Samples would not do: a
   * force that bounces between them has another mean and other extremes there.
   */
  struct ForceStatistics
  {
    double n_steps = 0.;
    /** Sums over the pairs that slide as in TransientSample, N: means, and
     * sums of the squares of what is beside them, N^2. */
    double mean_normal = 0., square_normal = 0.;
    double mean_tangential = 0., square_tangential = 0.;
    double min_normal = 0., max_normal = 0.; /**< N; 0 without steps */
    /** Mean of the leading edge's pressure over the mean one, times the normal
     * force, N. */
    double mean_edge = 0.;
    double n_apart   = 0.; /**< steps in which no node of any pair is closed */
    /** As SignalPiece::moment, N: what a line through the steps rises by. */
    double moment_normal = 0., moment_tangential = 0.;

    /** Adds one step. Forces in N, @p edge as in `mean_edge`. */
    void add(const double normal,
             const double tangential,
             const double edge,
             const bool   is_apart);

    /** Adds all steps of the stretch that follows. */
    void add(const ForceStatistics &other);

    /** Roots of the mean squares about the means, N; 0 without steps. */
    double rms_normal() const;
    double rms_tangential() const;

    /** The forces of the steps, N. */
    SignalPiece normal() const;
    SignalPiece tangential() const;
  };

  /** Equally long stretches that a run is cut into: its second half, the
   * quarters of that and the fifty stretches of a speed that changes are whole
   * numbers of them. */
  constexpr unsigned int n_force_stretches = 200;

  /** Of the stretch number @p first up to the one before @p end. */
  ForceStatistics statistics_of(const std::vector<ForceStatistics> &stretches,
                                const unsigned int                  first,
                                const unsigned int                  end);

  /** What both forces vibrate by in each quarter of some stretches, N, beside
   * the slow part of all of them (slow_part.h): a load that comes on, and
   * friction that follows a speed, are no vibration. */
  struct QuarterVibrations
  {
    std::vector<double> normal, tangential; /**< four each */
  };

  /** Of the stretch number @p first up to the one before @p end. */
  QuarterVibrations vibrations_of(const std::vector<ForceStatistics> &stretches,
                                  const unsigned int                  first,
                                  const unsigned int                  end);
} // namespace squeal

#endif
