// SPDX-License-Identifier: LGPL-2.1-or-later

// The coefficient of friction over the slip rate: values, slopes, what holds a
// node that sticks, and the shares of nodes that slide at different speeds.

#include "scenes.h"

#include <squeal/contact/friction_law.h>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  using Kind = ContactParameters::FrictionLaw;

  ContactParameters
  falling(const double decay_speed)
  {
    ContactParameters c;
    c.friction_law                = Kind::exponential;
    c.friction_coefficient        = .3;
    c.static_friction_coefficient = .5;
    c.decay_speed                 = decay_speed;
    c.sliding_speed               = .1;
    return c;
  }

  ContactParameters
  table()
  {
    ContactParameters c;
    c.friction_law          = Kind::table;
    c.friction_speeds       = {0., .1, .4};
    c.friction_coefficients = {.6, .4, .5};
    c.sliding_speed         = .05;
    return c;
  }

  /** The slope is that of the values, apart from corners. */
  void
  slopes(const ContactParameters &contact, const std::string &name)
  {
    const FrictionLaw law(contact);
    const double      h = 1e-6;
    for (const double v : {.01, .07, .2, .9})
      check_below(
        std::abs((law.coefficient(v + h) - law.coefficient(v - h)) / (2. * h) -
                 law.slope(v)),
        1e-8,
        name + ": slope at " + number(v) + " m/s");
  }

  /** About a point of a table vibrations have the mean of both slopes, and a
   * speed that is off by rounding is there, too. */
  void
  slopes_at_points(const ContactParameters &contact)
  {
    const FrictionLaw          law(contact);
    const std::vector<double> &v  = contact.friction_speeds,
                              &mu = contact.friction_coefficients;
    for (std::size_t i = 1; i < v.size(); ++i)
      {
        const double before = (mu[i] - mu[i - 1]) / (v[i] - v[i - 1]),
                     after  = i + 1 < v.size()
                                ? (mu[i + 1] - mu[i]) / (v[i + 1] - v[i])
                                : 0.;
        for (const double speed : {v[i], v[i] * (1. - 4e-16)})
          {
            check_close(law.slope(speed),
                        .5 * (before + after),
                        1e-12,
                        "slope at point " + number(v[i]));
            check_close(law.coefficient(speed),
                        mu[i],
                        1e-12,
                        "value at point " + number(v[i]));
          }
        ContactParameters there = contact;
        there.name              = "pad";
        there.sliding_speed     = v[i];
        check(remark_on_kink(there).find("'pad'") != std::string::npos,
              "a sliding speed there is named");
      }
    check(remark_on_kink(contact).empty(), "one between points is not");
    // Two slopes of 4 s/m that differ by rounding.
    ContactParameters straight     = contact;
    straight.friction_speeds       = {0., .05, .1};
    straight.friction_coefficients = {.3, .5, .7};
    straight.sliding_speed         = .05;
    check(remark_on_kink(straight).empty(), "nor a point of a straight line");
  }

  void
  values()
  {
    ContactParameters constant;
    constant.friction_coefficient = -.4;
    const FrictionLaw same(constant);
    check(same.is_constant() && same.coefficient(0.) == .4 &&
            same.coefficient(3.) == .4 && same.at_rest() == .4,
          "a constant law is the size of the coefficient at every slip rate");
    slopes(constant, "constant");

    const FrictionLaw smooth(falling(.05));
    check_close(smooth.coefficient(.05),
                .3 + .2 * std::exp(-1.),
                1e-15,
                "exponential law");
    check(smooth.coefficient(0.) == smooth.at_rest() &&
            std::abs(smooth.at_rest() - .5) < 1e-15,
          "exponential law: the static coefficient at rest");
    slopes(falling(.05), "exponential");

    const FrictionLaw jump(falling(0.));
    check(jump.coefficient(0.) == .3 && jump.coefficient(1.) == .3,
          "decay speed 0: the lower coefficient for all that slips");
    check(std::abs(jump.at_rest() - .5) < 1e-15,
          "decay speed 0: the static one for what sticks");
    slopes(falling(0.), "decay speed 0");

    const FrictionLaw points(table());
    for (const auto &[v, mu] :
         {std::make_pair(0., .6), {.05, .5}, {.1, .4}, {.25, .45}, {.4, .5}})
      check_close(points.coefficient(v), mu, 1e-14, "table");
    check(points.coefficient(7.) == .5, "table: the last value beyond");
    check(points.at_rest() == .6, "table: the first value at rest");
    slopes(table(), "table");
    slopes_at_points(table());
  }

  void
  nodes()
  {
    const std::vector<double> ratios = {.9, 1., 1.1};
    const ContactParameters   c      = falling(.05);
    const auto mu = [&](const double r) { return signed_coefficient(c, r); };
    const NodalShares shares = shares_of_largest(mu, ratios);
    check(shares.share[0] == 1. && shares.speed_ratio == .9,
          "a falling law is largest at the slowest node");
    for (unsigned int j = 0; j < 3; ++j)
      check_close(shares.share[j] * mu(shares.speed_ratio),
                  mu(ratios[j]),
                  1e-15,
                  "shares give the coefficient of node " + number(j));
    ContactParameters constant;
    check((shares_of_largest(
             [&](const double r) { return signed_coefficient(constant, r); },
             ratios)
             .share.array() == 1.)
            .all(),
          "no friction: all shares are one");

    ContactParameters back    = c;
    back.friction_coefficient = -.3;
    check(signed_coefficient(back, 1.) == -signed_coefficient(c, 1.),
          "a target that turns backwards has the other sign");
    constant.friction_slope = -.02;
    check(sliding_slope(constant, 1.) == -.02,
          "a constant law takes the slope of the parameters");
    check_close(sliding_slope(c, 1.1),
                -.2 / .05 * std::exp(-.11 / .05),
                1e-15,
                "others have their own");
    const NodalFriction sliding =
      FrictionLaw(c).in_sliding(Eigen::Vector3d(.9, 1., 1.1), -.1);
    check_close(sliding.coefficient[2], mu(1.1), 1e-15, "in sliding");
    check_close(sliding.slope[2], sliding_slope(c, 1.1), 1e-15, "its slope");
  }
} // namespace

int
main()
{
  values();
  nodes();
}
