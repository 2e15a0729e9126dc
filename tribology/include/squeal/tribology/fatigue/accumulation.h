// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_fatigue_accumulation_h
#define squeal_tribology_fatigue_accumulation_h

#include <map>

namespace squeal::tribology
{
  /**
   * Life of a history that repeats, by the damage curves of Manson and Halford
   * (1981): n of N cycles bring the damage to D = (n/N)^((N/N_ref)^0.4), and a
   * change of level keeps the damage. A block of high cycles followed by low
   * ones fails earlier than Miner's sum says, the reverse later.
   *
   * With t = -N_ref^0.4 ln D, which falls from infinity to 0 at failure, a
   * cycle that lives N takes N^-0.6 exp(N^-0.4 t) off t. Over many repetitions
   * of n_i cycles of life N_i the steps become a slope, and the life is
   *
   *   integral from 0 to infinity of  dt / sum_i n_i N_i^-0.6 exp(N_i^-0.4 t)
   *
   * repetitions. N_ref has gone, one level lives N cycles, and the history
   * twice lives half as many repetitions. The order inside a repetition has
   * gone as well: it moves the life by less than about one repetition.
   */
  class MansonHalford
  {
  public:
    /** Adds @p n cycles of which each would do @p damage (1/N) alone; none does
     * nothing, an infinite one leaves no life. */
    void add(double n, double damage);

    /** Share of the life that one repetition of what was added takes: 1 over
     * the life in repetitions. */
    double share() const;

  private:
    /** Cycles of about the same life. */
    struct Level
    {
      double n      = 0.; /**< cycles */
      double damage = 0.; /**< sum of n/N */
    };

    /** Levels to a factor e of the life: the memory does not grow with the
     * history. All cycles of a level do their mean damage, which moves the life
     * by less than 1e-4 of it. */
    static constexpr double levels_per_e = 32.;

    std::map<int, Level> levels; /**< by the logarithm of 1/N */
    bool                 breaks = false;
  };
} // namespace squeal::tribology

#endif
