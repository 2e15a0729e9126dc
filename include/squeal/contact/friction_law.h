// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_contact_friction_law_h
#define squeal_contact_friction_law_h

#include <squeal/parameters/scene_parameters.h>

#include <Eigen/Dense>

#include <functional>
#include <string>
#include <vector>

namespace squeal
{
  /** Of the closed nodes of a face that all slip. */
  struct NodalFriction
  {
    Eigen::VectorXd coefficient; /**< mu >= 0 */
    Eigen::VectorXd slope;       /**< dmu/d|v_t|, s/m */

    /** The same coefficient at every slip rate. */
    static NodalFriction uniform(const double       coefficient,
                                 const unsigned int n_nodes);
  };

  /** Values of nodes as shares of the one that is largest in size. */
  struct NodalShares
  {
    Eigen::VectorXd share;
    double          speed_ratio = 1.; /**< |V| / |V| at the centre, of that */
  };

  /**
   * The coefficient of friction over the slip rate |v_t|, of a contact pair:
   * constant, mu_k + (mu_s - mu_k) exp(-|v_t| / v_d), or linear between the
   * points of a table. A v_d of 0 means mu_s for nodes that stick and mu_k for
   * all that slip.
   */
  class FrictionLaw
  {
  public:
    explicit FrictionLaw(const ContactParameters &contact);

    bool is_constant() const;
    /** Whether nothing rubs at any slip rate. */
    bool is_frictionless() const;
    /** Whether all nodes that slip have one coefficient, those that stick the
     * same or a larger one. */
    bool is_constant_in_slip() const;
    /** mu >= 0 of a node that slips at @p slip_rate >= 0, m/s. */
    double coefficient(const double slip_rate) const;
    /** dmu/d|v_t|, s/m; at a point of a table the mean of both sides', by which
     * small vibrations about it grow. */
    double slope(const double slip_rate) const;
    /** The largest -dmu/d|v_t| between rest and @p slip_rate, m/s, in s/m; 0
     * where the coefficient does not fall, and where all slip rates have one.
     */
    double steepest_fall(const double slip_rate) const;
    /** Between two slip rates, m/s. */
    struct Range
    {
      double first, last;
    };
    /** Whether the coefficient rises with the slip rate anywhere. */
    bool rises() const;
    /** The longest range about @p slip_rate in which the coefficient nowhere
     * falls: @p slip_rate alone where it falls on both sides, or falls behind
     * rest. */
    Range rising_range(const double slip_rate) const;
    /** What the tangential force of a node that sticks is limited by. */
    double at_rest() const;

    /**
     * @name Memory
     * One number a node goes from step to step and is part of checkpoints.
     * These laws remember the slip rate, negative where the node stuck; a law
     * with a state of its own (a temperature, an age of the contact) keeps that
     * instead and lets it evolve in remember().
     */
    //@{
    static constexpr double stuck = -1.;
    /** After a step of @p duration, s, at @p slip_rate, m/s, or `stuck`;
     * @p before: what the node remembered, `stuck` at the start. */
    double remember(const double before,
                    const double slip_rate,
                    const double duration) const;
    /** mu of a node that remembers @p memory. */
    double recalled(const double memory) const;
    /** Slip rates in which mu of such a node is that of its next step. */
    Range range_recalled(const double memory) const;
    //@}

    /** Nodes that slip with the sliding speed @p speed, m/s, times their @p
     * speed_ratio. */
    NodalFriction in_sliding(const Eigen::VectorXd &speed_ratio,
                             const double           speed) const;

  private:
    ContactParameters::FrictionLaw kind;
    double                         kinetic, static_excess, decay_speed;
    std::vector<double>            speeds, coefficients;
  };

  /**
   * The laws of the nodes of several pairs, one pair after the other. The last
   * one goes on for as many nodes as are asked for.
   */
  class FrictionLaws
  {
  public:
    /** One for all nodes. */
    FrictionLaws(FrictionLaw law);

    /** From node @p first on, which is not below those of the laws so far. */
    void append(FrictionLaw law, const unsigned int first);

    const FrictionLaw &of(const unsigned int node) const;
    /** Whether no law depends on the slip rate. */
    bool is_constant() const;
    /** Whether some law somewhere rises with the slip rate. */
    bool rises() const;
    /** FrictionLaw::is_constant_in_slip() of every law. */
    bool is_constant_in_slip() const;
    /** mu of @p n_nodes nodes that stick. */
    Eigen::VectorXd at_rest(const unsigned int n_nodes) const;
    /** As FrictionLaw::in_sliding(), each node by its law; nodes without speed
     * stick, or slip with the slope at rest where friction rises from zero. */
    NodalFriction in_sliding(const Eigen::VectorXd &speed_ratio,
                             const double           speed) const;

  private:
    std::vector<FrictionLaw>  laws;
    std::vector<unsigned int> starts;
  };

  /** mu in steady sliding at |V| times @p speed_ratio, with the sign of the
   * pair's friction coefficient: negative where the target turns backwards. */
  double signed_coefficient(const ContactParameters &contact,
                            const double             speed_ratio);

  /** The law in words: "friction coefficient 0.3", or by what it depends on the
   * slip rate and what it is at the sliding speed. */
  std::string text_of_friction(const ContactParameters &contact);

  /** dmu/d|v_t| there, s/m: that of the law, or of a constant law the pair's
   * own `friction_slope`, which pairs at rest do not have. */
  double sliding_slope(const ContactParameters &contact,
                       const double             speed_ratio);

  /** Says so where the sliding speed is a point of the pair's table at which
   * the slope changes; else empty. */
  std::string remark_on_kink(const ContactParameters &contact);

  /** True where the matrices hold the normal forces of the contact: damping
   * across the sliding, or a coefficient that depends on the slip rate. */
  bool has_slip_rate_terms(const ContactParameters &contact);

  /** What @p value gives at each @p speed_ratio as shares of the largest; all
   * one where all are zero. */
  NodalShares shares_of_largest(const std::function<double(double)> &value,
                                const std::vector<double> &speed_ratio);
} // namespace squeal

#endif
