// SPDX-License-Identifier: LGPL-2.1-or-later

// The helper that the other tests decide by fails on what std::max lets pass.
#include <Eigen/Dense>

#include "worst.h"

using namespace squeal::testing;

namespace
{
  const double nan      = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();

  /** Neither within the widest limits nor beyond any. */
  void
  expect_failure(const Worst &worst, const std::string &text)
  {
    check(!worst.is_within(infinity) && !worst.stays_above(-infinity) &&
            !(worst.largest() > 0.) && !(worst.smallest() < 0.),
          text);
  }

  void
  values()
  {
    Worst worst;
    expect_failure(worst, "no value at all is a failure");
    worst.add(2., "a");
    worst.add(3., "b");
    worst.add(-1., "c");
    check(worst.largest() == 3. && worst.place_of_largest() == "b" &&
            worst.smallest() == -1. && worst.place_of_smallest() == "c" &&
            worst.size() == 3,
          "extremes and their places");
    check(worst.is_within(3.) && !worst.is_within(2.9) &&
            worst.stays_above(-1.) && !worst.stays_above(-.9),
          "limits on both sides");
    worst.add(infinity);
    check(!worst.is_within(1e300), "an infinite value is beyond every limit");
  }

  void
  not_a_number()
  {
    for (unsigned int place = 0; place < 3; ++place)
      {
        Worst worst;
        for (unsigned int i = 0; i < 3; ++i)
          worst.add(i == place ? nan : 1e-16, std::to_string(i));
        expect_failure(worst, "NaN at place " + std::to_string(place));
        check(worst.place_of_largest() == std::to_string(place),
              "the place of the NaN is kept");
      }
  }

  void
  matrices()
  {
    // Long enough for packets, at every place in and behind them.
    for (unsigned int place = 0; place < 11; ++place)
      {
        Eigen::VectorXd v = Eigen::VectorXd::LinSpaced(11, -2., 3.);
        check(largest(v) == 3. && smallest(v) == -2. && largest_abs(v) == 3.,
              "extremes of a vector");
        v[place] = nan;
        check(std::isnan(largest(v)) && std::isnan(smallest(v)) &&
                std::isnan(largest_abs(v)),
              "NaN in a vector at place " + std::to_string(place));
      }
    Eigen::MatrixXcd c = Eigen::MatrixXcd::Ones(3, 3);
    check(largest_abs(c) == 1., "a complex matrix");
    c(1, 1) = {0., nan};
    check(std::isnan(largest_abs(c)), "NaN in an imaginary part");
    check(std::isnan(largest(Eigen::VectorXd())), "an empty vector");
  }
} // namespace

int
main()
{
  values();
  not_a_number();
  matrices();
}
