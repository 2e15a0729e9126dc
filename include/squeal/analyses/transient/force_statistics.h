// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_analyses_transient_force_statistics_h
#define squeal_analyses_transient_force_statistics_h

#include <squeal/transient/slow_part.h>

#include <array>
#include <vector>

namespace squeal
{
  /** Contact forces after one step, sums over the pairs that slide as in
   * TransientSample, N. */
  struct StepSums
  {
    /** Resultants; on a curved face, where pressure has a part in that along
     * the sliding, the tangential one is the sum of the nodes' friction. */
    double normal = 0., tangential = 0.;
    double edge = 0.;     /**< pressure at the leading edge over the mean one,
                             times `pressing` */
    double pressing = 0.; /**< of the nodes' normal forces */
    double friction = 0.; /**< of what nodes have along their own sliding */
    /** PressureMoments of a pair; 0 of sums over several. */
    double first_moment = 0., second_moment = 0.;
  };

  /** A force of a pair whose vibration is judged: the sums, a combination of
   * both PressureMoments and the normal force of a node. */
  enum class JudgedForce
  {
    normal,
    tangential,
    moment,
    node
  };

  /** Parts of both PressureMoments in a combination of them, whose squares add
   * up to 1. */
  using MomentParts = std::array<double, 2>;

  /** The combination that vibrates most, where both vibrate by the mean squares
   * @p first and @p second and their product has the mean @p mixed, N^2. A
   * wobble that goes round vibrates alike along all: then the first one. */
  MomentParts loudest_moment(const double first,
                             const double second,
                             const double mixed);

  /** Mean pressure at the leading edge over that of the face; NaN where nothing
   * presses. */
  double leading_edge_factor(const StepSums &sums);

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
    /** Means of those in StepSums, N: on a curved face other ones than of the
     * resultants. */
    double mean_edge = 0., mean_pressing = 0., mean_friction = 0.;
    double n_apart = 0.; /**< steps in which no node of any pair is closed */
    /** As SignalPiece::moment, N: what a line through the steps rises by. */
    double moment_normal = 0., moment_tangential = 0.;
    /** The same of both PressureMoments of a pair, N. */
    double mean_first = 0., square_first = 0., moment_first = 0.;
    double mean_second = 0., square_second = 0., moment_second = 0.;
    /** Sum of the products of what both are beside their means, N^2. */
    double mixed_moments = 0.;

    /** Adds one step. */
    void add(const StepSums &sums, const bool is_apart);

    /** Adds all steps of the stretch that follows. */
    void add(const ForceStatistics &other);

    /** Roots of the mean squares about the means, N; 0 without steps. */
    double rms_normal() const;
    double rms_tangential() const;

    /** The forces of the steps, N. */
    SignalPiece normal() const;
    SignalPiece tangential() const;
    SignalPiece first_moment() const;
    SignalPiece second_moment() const;
    /** A combination of both. */
    SignalPiece moment(const MomentParts &parts) const;
    /** Mean friction over mean normal force of the nodes, of the leading edge's
     * pressure over the mean one; NaN where nothing presses. */
    double macroscopic_friction() const;
    double leading_edge_factor() const;
  };

  /** Puts the values of @p other behind those of @p piece. */
  void join(const SignalPiece &other, SignalPiece &piece);

  /** Root of the mean square about the mean, in the unit of the signal; 0
   * without values. */
  double rms_of(const SignalPiece &piece);

  /** Equally long stretches that a run is cut into: its second half, the
   * quarters of that and the fifty stretches of a speed that changes are whole
   * numbers of them. */
  constexpr unsigned int n_force_stretches = 200;

  /** Equal parts of the time of a run with a trigger: a tenth of them to a
   * hundredth of the run, so that what a window begins or ends within is a
   * small part of it. */
  constexpr unsigned int n_trigger_stretches = 1000;

  /** Of the stretch number @p first up to the one before @p end. */
  ForceStatistics statistics_of(const std::vector<ForceStatistics> &stretches,
                                const unsigned int                  first,
                                const unsigned int                  end);

  /** What the forces vibrate by in each quarter of some stretches, N, beside
   * the slow part of all of them (slow_part.h): a load that comes on, and
   * friction that follows a speed, are no vibration. */
  struct QuarterVibrations
  {
    std::vector<double> normal, tangential; /**< four each */
    MomentParts parts{{1., 0.}}; /**< of the moment that vibrates most */
    std::vector<double> moment;  /**< what that does */

    /** Of one of these, not of a node. */
    const std::vector<double> &of(const JudgedForce force) const;
  };

  /** The rms over the last two of four @p quarters less that over the first two,
   * N. */
  double change_of_rms(const std::vector<double> &quarters);

  /** That over the larger one of the two, -1 to 1; 0 where both are 0. */
  double share_of_change(const std::vector<double> &quarters);

  /** Of the stretch number @p first up to the one before @p end. */
  QuarterVibrations vibrations_of(const std::vector<ForceStatistics> &stretches,
                                  const unsigned int                  first,
                                  const unsigned int                  end);
} // namespace squeal

#endif
