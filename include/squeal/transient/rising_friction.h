// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_transient_rising_friction_h
#define squeal_transient_rising_friction_h

#include <squeal/contact/friction_law.h>

#include <optional>

namespace squeal
{
  /**
   * The friction of a node within a step, where it follows the slip rate of
   * that step: that of its law in a range in which this nowhere falls, and
   * constant beyond. The force for a motion is then one alone, whatever the
   * step, and the same motion with a law that lags would change its sign from
   * step to step.
   */
  class RisingFriction
  {
  public:
    /** Of a node whose coefficient does not follow the slip rate. */
    RisingFriction() = default;
    /** @p law is kept by reference. @p added: to its coefficient; a sum below 0
     * counts as 0. */
    RisingFriction(const FrictionLaw       &law,
                   const FrictionLaw::Range range,
                   const double             added);

    /** Whether the coefficient follows the slip rate. */
    bool follows() const;
    /** mu >= 0 at the @p slip_rate >= 0, m/s. */
    double coefficient(const double slip_rate) const;

    struct Slip
    {
      double friction; /**< mu there */
      double slope;    /**< dmu/d(slip), 1/m */
    };
    /**
     * Where rho s + mu(s / dt) p = x with the slip s >= 0, m: what is left of
     * the force @p tried, x in N, after the slip takes @p stiffness rho, N/m,
     * off it. Empty where x does not exceed mu(0) p: the node sticks.
     *
     * @param normal    p > 0, N
     * @param duration  dt, s
     */
    std::optional<Slip> slip(const double tried,
                             const double normal,
                             const double stiffness,
                             const double duration) const;

  private:
    double slope(const double slip_rate) const;

    const FrictionLaw *law   = nullptr;
    FrictionLaw::Range range = {0., 0.};
    double             added = 0.;
  };
} // namespace squeal

#endif
