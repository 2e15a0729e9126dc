// SPDX-License-Identifier: LGPL-2.1-or-later

// What a force vibrates by beside its drift: a polynomial and a load that comes
// on leave nothing, a line on top of them what it has alone, and statistics of
// stretches are those of their steps.

#include "worst.h"

#include <squeal/analyses/transient/force_statistics.h>

#include <cmath>
#include <functional>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  constexpr double pi = 3.14159265358979323846;

  using Signal = std::function<double(double)>;

  /** Stretches of @p n_steps steps of a force over times from 0 to 1. */
  std::vector<ForceStatistics>
  stretches_of(const Signal &force, const unsigned int n_steps)
  {
    std::vector<ForceStatistics> stretches(n_force_stretches);
    for (unsigned int k = 0; k < n_steps; ++k)
      {
        StepSums sums;
        sums.normal     = force((k + .5) / n_steps);
        sums.tangential = .3 * sums.normal;
        stretches[std::size_t(k) * n_force_stretches / n_steps].add(sums,
                                                                    false);
      }
    return stretches;
  }

  /** The second half of a run. */
  QuarterVibrations
  late(const Signal &force, const unsigned int n_steps = 20000)
  {
    return vibrations_of(
      stretches_of(force, n_steps), n_force_stretches / 2, n_force_stretches);
  }

  Worst
  worst_of_all(const QuarterVibrations &v, const double expected)
  {
    Worst worst;
    for (const double rms : v.normal)
      worst.add(std::abs(rms - expected));
    for (const double rms : v.tangential)
      worst.add(std::abs(rms / .3 - expected));
    return worst;
  }

  double
  half_cosine(const double t)
  {
    return 50. * (1. - std::cos(pi * t / 1.5));
  }

  void
  drifts()
  {


    check_within(
      worst_of_all(late([](const double t) { return 100. + 40. * t; }), 0.),
      1e-10,
      "a straight line leaves nothing");
    check_within(worst_of_all(late([](const double t) {
                                return 100. - 7. * t * t + 30. * t * t * t;
                              }),
                              0.),
                 1e-3,
                 "nor does a curved one, but within a stretch");
    check_within(worst_of_all(late(half_cosine), 0.),
                 5e-3,
                 "a load that comes on is less than 1e-4 of its mean");
    const Signal line = [](const double t) {
      return 2. * std::sin(2. * pi * 160. * t);
    };
    const Signal both = [&](const double t) {
      return half_cosine(t) + 80. * t + line(t);
    };
    const double rms = std::sqrt(2.);
    check_within(worst_of_all(late(line), rms),
                 5e-3 * rms,
                 "a line of eighty periods keeps its size");
    check_within(
      worst_of_all(late(both), rms), 1e-2 * rms, "beside a drift as well");
    check_within(
      worst_of_all(late([](const double t) { return 9. - t; }, 150), 0.),
      1e-10,
      "there may be fewer steps than stretches");
  }

  /** Of all steps at once, by the definitions. */
  void
  statistics()
  {
    constexpr unsigned int n     = 1234;
    const Signal           force = [](const double t) {
      return 100. + 3. * t + std::sin(40. * t);
    };
    const SignalPiece all =
      statistics_of(stretches_of(force, n), 0, n_force_stretches).normal();
    double mean = 0., square = 0., moment = 0.;
    for (unsigned int k = 0; k < n; ++k)
      mean += force((k + .5) / n) / n;
    for (unsigned int k = 0; k < n; ++k)
      {
        const double beside = force((k + .5) / n) - mean;
        square += beside * beside;
        moment += k * beside;
      }
    check_close(all.n, n, 1e-14, "all steps");
    check_close(all.mean, mean, 1e-12, "their mean");
    check_close(all.square, square, 1e-9, "squares about it");
    check_close(all.moment, moment, 1e-9, "and moment");
  }

  void
  samples()
  {
    std::vector<double> drift, few;
    for (unsigned int k = 0; k < 400; ++k)
      drift.push_back(3. + .1 * k - 1e-3 * k * k);
    Worst left;
    for (const double x : without_slow_part(drift, 2))
      left.add(std::abs(x));
    check_within(left, 1e-10, "a parabola less a parabola");
    double sum = 0.;
    for (const double x : without_slow_part(drift, 0))
      sum += x;
    check(std::abs(sum) <= 1e-9, "degree 0 takes the mean");
    few.assign(drift.begin(), drift.begin() + 5);
    const std::vector<double> rest = without_slow_part(few);
    check_close(rest[4] - rest[0],
                few[4] - few[0],
                1e-12,
                "a few values keep all but their mean");
    check(without_slow_part({}).empty(), "no values");
  }
} // namespace

int
main()
{
  drifts();
  statistics();
  samples();
}
