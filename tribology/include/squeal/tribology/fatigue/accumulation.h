// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_fatigue_accumulation_h
#define squeal_tribology_fatigue_accumulation_h

namespace squeal::tribology
{
  /**
   * Damage curves of Manson and Halford (1981): n of N cycles bring the damage
   * to (n/N)^((N/N_ref)^0.4), and a change of level keeps the damage. A block
   * of high cycles followed by low ones fails earlier than Miner's sum says,
   * the reverse later.
   */
  class MansonHalford
  {
  public:
    explicit MansonHalford(double reference_life);

    /** Adds @p n cycles at a level of @p life; an infinite one does nothing. */
    void add(double n, double life);

    /** Damage on the curve of the reference life: 1 is failure. */
    double damage() const;

    /** Part of the life at a level of @p life that is left. */
    double rest(double life) const;

  private:
    /** Life fraction used, seen from a level of this life. */
    double used(double life) const;

    double reference_life;
    double logarithm; /**< of the damage */
  };
} // namespace squeal::tribology

#endif
