// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_fatigue_damage_counter_h
#define squeal_tribology_fatigue_damage_counter_h

#include <squeal/tribology/fatigue/accumulation.h>
#include <squeal/tribology/fatigue/mean_stress.h>
#include <squeal/tribology/fatigue/rainflow.h>
#include <squeal/tribology/fatigue/range_mean_matrix.h>
#include <squeal/tribology/fatigue/sn_curve.h>

#include <array>
#include <optional>
#include <vector>

namespace squeal::tribology
{
  /** What a history is counted with, common to all nodes. */
  struct CountingRules
  {
    RainflowCounter::Residue        residue;
    std::vector<SnCurve>            curves;
    MeanStressCorrection            correction;
    FatigueParameters::Accumulation accumulation;
    /** Straight lines for a second sum, as spectral estimates take them:
     * without knee, limit and mean stress, by Miner's rule. Empty: none. */
    std::vector<SnCurve> straight_curves = {};
    /** Axes of the range-mean matrices; no matrices if not given. */
    std::optional<RangeMeanMatrix> empty_matrix;
  };

  /** The rules of the section "Fatigue", without matrices. */
  CountingRules counting_rules(const FatigueParameters &fatigue);

  /**
   * Damage of one stress history that comes in pieces: rainflow cycles are
   * collected, corrected for their mean and added up for every S-N curve, to
   * Miner's sum or to the share of the life that the history takes where it
   * repeats (MansonHalford); both are 1 over the life in repetitions. What
   * comes out does not depend on the pieces, to the last bit.
   */
  class DamageCounter
  {
  public:
    /** @p rules must live as long as the counter. */
    explicit DamageCounter(const CountingRules &rules);

    /** Adds @p n stresses (Pa, tension positive), @p stride apart. */
    void add(const double *stresses, std::size_t n, std::size_t stride = 1);

    /** Ends the history. */
    void finish();

    /** Damage for each curve; valid after finish(). */
    const std::vector<double> &damages() const;

    /** Miner's sums for each curve of the cycles that have been closed so far,
     * by whatever damage accumulates. */
    const std::vector<double> &closed_damages();

    /** The same of all cycles; valid after finish(). */
    const std::vector<double> &miner_sums() const;

    /** Damage for each straight curve, empty if the rules have none. */
    const std::vector<double> &straight_damages() const;

    /** Cycles, half ones as 0.5. */
    double n_cycles() const;

    double largest_range() const;

    /** Most points that were kept at a time. */
    std::size_t deepest() const;

    /** The matrix, empty if the rules have none. */
    const std::optional<RangeMeanMatrix> &matrix() const;

  private:
    static constexpr std::size_t batch = 512;

    void flush();
    void take(double range, double mean, double count);

    const CountingRules           *rules;
    RainflowCounter                counter;
    std::array<double, batch>      ranges, means, counts;
    std::size_t                    n_waiting = 0;
    std::vector<double>            miner, sums, straight_sums;
    std::vector<MansonHalford>     curves_of_damage;
    double                         cycles  = 0.;
    double                         largest = 0.;
    std::optional<RangeMeanMatrix> range_mean;
  };
} // namespace squeal::tribology

#endif
