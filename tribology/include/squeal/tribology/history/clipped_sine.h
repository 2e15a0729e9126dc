// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_history_clipped_sine_h
#define squeal_tribology_history_clipped_sine_h

#include <squeal/results/contact_history.h>
#include <squeal/tribology/setup/damage_parameters.h>

#include <random>
#include <vector>

namespace squeal::tribology
{
  /** The periodic load max(0, 1 + r sin): closed forms, r >= 0. */
  struct ClippedSine
  {
    double r;

    double duty() const; /**< part of the time in contact */
    double mean() const; /**< over a period */
    double peak() const; /**< 1 + r */
  };

  /**
   * A contact history with the published factors of the thesis, on the square
   * face of its pad:
   *
   *   p(x, y, t) = m max(0, 1 + r (1 + modulation) sin(2 pi f t + phase))
   *
   * The time mean falls from the leading edge (y = -b/2), most at the inner
   * radius (x = -b/2), as B + C exp(-(y + b/2) / (0.15 b)) (1 - 0.15 x /
   * (b/2)); B and C follow from the mean pressure of the pad and from the peak
   * at the leading inner corner, `leading` times that mean. r falls linearly
   * from 5 at the leading to 0.3 at the trailing edge, the phase by a quarter
   * period. The slip rate is v (1 + 0.24 r sin(... + pi/2)); where that is
   * negative the node sticks and carries 0.9 mu p. The silent run has the same
   * means with r = 0. Every node has a modulation of its own, correlated over
   * two periods.
   */
  class ClippedSineGenerator
  {
  public:
    explicit ClippedSineGenerator(const RecordedHistoryParameters &parameters);

    const HistoryLayout &layout() const;

    std::uint64_t n_samples() const;

    /** The next @p n samples and the openings and closures in them. */
    void next(std::size_t                n,
              HistorySamples            &samples,
              std::vector<StatusChange> &changes);

    /** Mean in time of a node without modulation, Pa. */
    double mean_pressure(std::size_t node) const;

    /** r of a node; 0 in the silent run. */
    double ratio(std::size_t node) const;

  private:
    void set_means();

    RecordedHistoryParameters        p;
    HistoryLayout                    what;
    std::vector<double>              means, ratios, phases, modulation, before;
    std::uint64_t                    n_done = 0;
    std::mt19937_64                  generator;
    std::normal_distribution<double> normal;
  };
} // namespace squeal::tribology

#endif
