// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_damage_peak_loss_h
#define squeal_tribology_damage_peak_loss_h

#include <squeal/tribology/fatigue/damage_counter.h>
#include <squeal/tribology/fatigue/peak_sharpener.h>

#include <string>
#include <vector>

namespace squeal::tribology
{
  /**
   * How much damage a history loses because its samples miss the peaks: it is
   * counted once more with the peaks of PeakSharpener, by the rules of the
   * section "Fatigue" for the largest exponent, which loses most. An estimate:
   * exact for sines, and blind to what comes and goes between two samples.
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

    /** Ends the history. Share, 0 to 1, of the mean damage of the face that is
     * lost; @p damages are those of the samples for that exponent and @p areas
     * the tributary areas, m^2, one a node. 0 where nothing is counted. */
    double finish(const std::vector<double> &damages,
                  const std::vector<double> &areas);

    /** A line for a run that loses more than 5 %, "" for others. */
    static std::string note(double share, double exponent);

  private:
    std::size_t                number; /**< of the exponent */
    CountingRules              rules;
    std::vector<DamageCounter> counters;
    std::vector<PeakSharpener> sharpeners;
    std::vector<double>        values; /**< room for a piece */
  };
} // namespace squeal::tribology

#endif
