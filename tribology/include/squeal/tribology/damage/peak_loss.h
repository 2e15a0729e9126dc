// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_damage_peak_loss_h
#define squeal_tribology_damage_peak_loss_h

#include <squeal/tribology/fatigue/damage_counter.h>
#include <squeal/tribology/fatigue/peak_sharpener.h>

#include <string>
#include <vector>

namespace squeal::tribology
{
  /** What the samples of a history miss of its damage. */
  struct LostDamage
  {
    double share = 0.; /**< 0 to 1, an estimate */
    /** Whether the samples tell it: not where unseen extrema (PeakSharpener)
     * carry more than a fifth of the damage. */
    bool is_known = true;
  };

  /**
   * How much damage a history loses because its samples miss the peaks: it is
   * counted once more with the peaks of PeakSharpener, by the rules of the
   * section "Fatigue" for the largest exponent, which loses most. An estimate:
   * exact for sines, within a tenth of the damage for pulses of a contact that
   * opens, not known for pulses of fewer than three samples, and blind to what
   * comes and goes between two samples.
   */
  class PeakLoss
  {
  public:
    PeakLoss(const FatigueParameters &fatigue, std::size_t n_nodes);
    // the counters point to the rules
    PeakLoss(const PeakLoss &)            = delete;
    PeakLoss &operator=(const PeakLoss &) = delete;

    /** Adds @p n stresses (Pa, tension positive) of a node. */
    void add(std::size_t node, const double *stresses, std::size_t n);

    /** Which of the exponents is the largest. */
    std::size_t exponent() const;

    /** Ends the history. What is lost of the mean damage of the face;
     * @p damages are those of the samples for that exponent and @p areas
     * the tributary areas, m^2, one a node. 0 where nothing is counted. */
    LostDamage finish(const std::vector<double> &damages,
                      const std::vector<double> &areas);

    /** The share in percent, or that it is not known. */
    static std::string figure(const LostDamage &lost);

    /** A line for a run that loses more than 5 % or an unknown share, "" for
     * others. */
    static std::string note(const LostDamage &lost, double exponent);

  private:
    std::size_t                number; /**< of the exponent */
    CountingRules              rules;
    std::vector<DamageCounter> counters;
    std::vector<PeakSharpener> sharpeners;
    std::vector<double>        values; /**< room for a piece */
  };
} // namespace squeal::tribology

#endif
