// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/number_text.h>
#include <squeal/base/unknown_choice.h>
#include <squeal/contact/friction_law.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace squeal
{
  NodalFriction
  NodalFriction::uniform(const double coefficient, const unsigned int n)
  {
    return {Eigen::VectorXd::Constant(n, coefficient),
            Eigen::VectorXd::Zero(n)};
  }



  namespace
  {
    /** Of a table, s/m, before point @p i of it; 0 behind the last one. */
    double
    slope_before(const std::size_t          i,
                 const std::vector<double> &speeds,
                 const std::vector<double> &coefficients)
    {
      return i < speeds.size() ? (coefficients[i] - coefficients[i - 1]) /
                                   (speeds[i] - speeds[i - 1])
                               : 0.;
    }

    /** The point of a table at speed @p v, but for rounding, other than the
     * first one, at rest. */
    std::optional<std::size_t>
    point_at(const double v, const std::vector<double> &speeds)
    {
      constexpr double rounding = 1e-9;
      for (std::size_t i = 1; i < speeds.size(); ++i)
        if (std::abs(v - speeds[i]) <= rounding * speeds[i])
          return i;
      return {};
    }
  } // namespace



  FrictionLaw::FrictionLaw(const ContactParameters &c)
    : kind(c.friction_law)
    , kinetic(std::abs(c.friction_coefficient))
    , static_excess(c.static_friction_coefficient - kinetic)
    , decay_speed(c.decay_speed)
    , speeds(c.friction_speeds)
    , coefficients(c.friction_coefficients)
  {
  }



  bool
  FrictionLaw::is_constant() const
  {
    return kind == ContactParameters::FrictionLaw::constant;
  }



  bool
  FrictionLaw::is_frictionless() const
  {
    if (kind == ContactParameters::FrictionLaw::table)
      return std::all_of(coefficients.begin(),
                         coefficients.end(),
                         [](const double mu) { return mu == 0.; });
    return kinetic == 0. && (is_constant() || static_excess == 0.);
  }



  bool
  FrictionLaw::is_constant_in_slip() const
  {
    return is_constant() ||
           (kind == ContactParameters::FrictionLaw::exponential &&
            decay_speed == 0.);
  }



  double
  FrictionLaw::coefficient(const double v) const
  {
    if (kind == ContactParameters::FrictionLaw::exponential)
      return decay_speed > 0.
               ? kinetic + static_excess * std::exp(-v / decay_speed)
               : kinetic;
    if (kind == ContactParameters::FrictionLaw::constant)
      return kinetic;
    if (v >= speeds.back())
      return coefficients.back();
    const std::size_t i =
      std::upper_bound(speeds.begin(), speeds.end(), v) - speeds.begin();
    Assert(i > 0, dealii::ExcInternalError());
    return coefficients[i - 1] +
           slope_before(i, speeds, coefficients) * (v - speeds[i - 1]);
  }



  double
  FrictionLaw::slope(const double v) const
  {
    if (kind == ContactParameters::FrictionLaw::exponential)
      return decay_speed > 0.
               ? -static_excess / decay_speed * std::exp(-v / decay_speed)
               : 0.;
    if (kind == ContactParameters::FrictionLaw::constant)
      return 0.;
    // A small vibration about a point of the table sees both slopes for half of
    // the time: it gains and loses by their mean.
    if (const auto i = point_at(v, speeds))
      return .5 * (slope_before(*i, speeds, coefficients) +
                   slope_before(*i + 1, speeds, coefficients));
    return slope_before(std::upper_bound(speeds.begin(), speeds.end(), v) -
                          speeds.begin(),
                        speeds,
                        coefficients);
  }



  double
  FrictionLaw::steepest_fall(const double v) const
  {
    // The exponential law is steepest at rest, a table between its points.
    if (kind != ContactParameters::FrictionLaw::table)
      return std::max(0., -slope(0.));
    double result = 0.;
    for (std::size_t i = 1; i < speeds.size() && speeds[i - 1] <= v; ++i)
      result = std::max(result, -slope_before(i, speeds, coefficients));
    return result;
  }



  bool
  FrictionLaw::rises() const
  {
    return kind == ContactParameters::FrictionLaw::table
             ? std::adjacent_find(coefficients.begin(),
                                  coefficients.end(),
                                  std::less<double>()) != coefficients.end()
             : slope(0.) > 0.;
  }

  FrictionLaw::Range
  FrictionLaw::rising_range(const double v) const
  {
    constexpr double any = std::numeric_limits<double>::infinity();
    if (kind != ContactParameters::FrictionLaw::table)
      return slope(0.) > 0. ? Range{0., any} : Range{v, v};
    const auto falls_before = [&](const std::size_t i) {
      return slope_before(i, speeds, coefficients) < 0.;
    };
    const std::size_t n = speeds.size();
    // The first point above v, and the first that is not below it.
    std::size_t above = std::upper_bound(speeds.begin(), speeds.end(), v) -
                        speeds.begin(),
                at = std::lower_bound(speeds.begin(), speeds.end(), v) -
                     speeds.begin();
    Range result{v, v};
    for (; above <= n && !falls_before(above); ++above)
      result.last = above < n ? speeds[above] : any;
    for (; at > 0 && !falls_before(at); --at)
      result.first = speeds[at - 1];
    return result;
  }



  double
  FrictionLaw::at_rest() const
  {
    if (kind == ContactParameters::FrictionLaw::exponential)
      return kinetic + static_excess;
    return coefficient(0.);
  }



  double
  FrictionLaw::remember(const double /*before*/,
                        const double slip_rate,
                        const double /*duration*/) const
  {
    return slip_rate;
  }

  double
  FrictionLaw::recalled(const double memory) const
  {
    return memory >= 0. ? coefficient(memory) : at_rest();
  }

  FrictionLaw::Range
  FrictionLaw::range_recalled(const double memory) const
  {
    return rising_range(std::max(0., memory));
  }



  NodalFriction
  FrictionLaw::in_sliding(const Eigen::VectorXd &speed_ratio,
                          const double           speed) const
  {
    NodalFriction result = NodalFriction::uniform(0., speed_ratio.size());
    for (Eigen::Index j = 0; j < speed_ratio.size(); ++j)
      {
        const double v        = std::abs(speed) * speed_ratio[j];
        result.coefficient[j] = coefficient(v);
        result.slope[j]       = slope(v);
      }
    return result;
  }



  FrictionLaws::FrictionLaws(FrictionLaw law)
    : laws{std::move(law)}
    , starts{0}
  {
  }

  void
  FrictionLaws::append(FrictionLaw law, const unsigned int first)
  {
    Assert(first >= starts.back(), dealii::ExcInternalError());
    laws.push_back(std::move(law));
    starts.push_back(first);
  }

  const FrictionLaw &
  FrictionLaws::of(const unsigned int node) const
  {
    return laws[std::upper_bound(starts.begin(), starts.end(), node) -
                starts.begin() - 1];
  }

  bool
  FrictionLaws::is_constant() const
  {
    return std::all_of(laws.begin(), laws.end(), [](const auto &law) {
      return law.is_constant();
    });
  }

  bool
  FrictionLaws::rises() const
  {
    return std::any_of(
      laws.begin(), laws.end(), [](const auto &law) { return law.rises(); });
  }

  bool
  FrictionLaws::is_constant_in_slip() const
  {
    return std::all_of(laws.begin(), laws.end(), [](const auto &law) {
      return law.is_constant_in_slip();
    });
  }

  Eigen::VectorXd
  FrictionLaws::at_rest(const unsigned int n_nodes) const
  {
    Eigen::VectorXd result(n_nodes);
    for (unsigned int j = 0; j < n_nodes; ++j)
      result[j] = of(j).at_rest();
    return result;
  }

  NodalFriction
  FrictionLaws::in_sliding(const Eigen::VectorXd &speed_ratio,
                           const double           speed) const
  {
    NodalFriction result = NodalFriction::uniform(0., speed_ratio.size());
    for (Eigen::Index j = 0; j < speed_ratio.size(); ++j)
      {
        const FrictionLaw &law   = of(j);
        const double       v     = std::abs(speed) * speed_ratio[j];
        const bool         slips = v > 0. || law.at_rest() == 0.;
        result.coefficient[j]    = v > 0. ? law.coefficient(v) : law.at_rest();
        result.slope[j]          = slips ? law.slope(v) : 0.;
      }
    return result;
  }



  double
  signed_coefficient(const ContactParameters &c, const double speed_ratio)
  {
    return std::copysign(
      FrictionLaw(c).coefficient(c.sliding_speed * speed_ratio),
      c.friction_coefficient);
  }

  std::string
  text_of_friction(const ContactParameters &c)
  {
    const auto text     = [](const double x) { return rounded_text(x, 4); };
    const auto at_speed = [&]() {
      return ", " + text(signed_coefficient(c, 1.)) + " at the sliding speed " +
             text(c.sliding_speed) + " m/s";
    };
    switch (c.friction_law)
      {
      case ContactParameters::FrictionLaw::constant:
        return "friction coefficient " +
               rounded_text(c.friction_coefficient, 6);
      case ContactParameters::FrictionLaw::exponential:
        return "friction from " + text(c.static_friction_coefficient) +
               " at rest to " + text(c.friction_coefficient) +
               (c.decay_speed > 0.
                  ? " by exp(-|v| / " + text(c.decay_speed) + " m/s)"
                  : " in all that slips") +
               at_speed();
      case ContactParameters::FrictionLaw::table:
        return "friction by a table, " + text(c.friction_coefficients.front()) +
               " at rest to " + text(c.friction_coefficients.back()) +
               " from " + text(c.friction_speeds.back()) + " m/s on" +
               at_speed();
      }
    unknown_choice("friction law");
  }

  double
  sliding_slope(const ContactParameters &c, const double speed_ratio)
  {
    const FrictionLaw law(c);
    if (law.is_constant()) // whose slope is that of sliding alone
      return c.sliding_speed > 0. ? c.friction_slope : 0.;
    return law.slope(c.sliding_speed * speed_ratio);
  }



  std::string
  remark_on_kink(const ContactParameters &c)
  {
    if (c.friction_law != ContactParameters::FrictionLaw::table)
      return "";
    const auto i = point_at(c.sliding_speed, c.friction_speeds);
    if (!i)
      return "";
    const double before =
                   slope_before(*i, c.friction_speeds, c.friction_coefficients),
                 after = slope_before(
                   *i + 1, c.friction_speeds, c.friction_coefficients);
    // Slopes that differ by the rounding of the table alone are one.
    constexpr double rounding = 1e-9;
    return std::abs(before - after) <=
               rounding * std::max(std::abs(before), std::abs(after))
             ? ""
             : "the sliding speed of contact '" + c.name + "', " +
                 rounded_text(c.sliding_speed, 4) +
                 " m/s, is a point of its table of friction, where the slope "
                 "changes from " +
                 rounded_text(before, 3) + " to " + rounded_text(after, 3) +
                 " s/m: growth rates are those of the mean slope, which small "
                 "vibrations about the point have";
  }



  bool
  has_slip_rate_terms(const ContactParameters &c)
  {
    return c.transverse_slip_term || c.friction_slope != 0. ||
           !FrictionLaw(c).is_constant();
  }



  NodalShares
  shares_of_largest(const std::function<double(double)> &value,
                    const std::vector<double>           &speed_ratio)
  {
    Eigen::VectorXd values(speed_ratio.size());
    for (std::size_t j = 0; j < speed_ratio.size(); ++j)
      values[j] = value(speed_ratio[j]);
    Eigen::Index largest = 0;
    NodalShares  result{Eigen::VectorXd::Ones(values.size()), 1.};
    if (values.size() == 0 || values.cwiseAbs().maxCoeff(&largest) == 0.)
      return result;
    result.share       = values / values[largest];
    result.speed_ratio = speed_ratio[largest];
    return result;
  }
} // namespace squeal
