// SPDX-License-Identifier: LGPL-2.1-or-later

// A mass whose two modes couple by friction on a belt, with contact loss and
// stick: shooting and harmonic balance against a long transient, derivative of
// the steps against difference quotients, multipliers against what small
// disturbances do, and motions that are found from far away.

#include "cycle/two_modes.h"
#include "scenes.h"
#include "worst.h"

#include <squeal/cycle/harmonic_balance.h>
#include <squeal/transient/linearized_motion.h>

#include <cmath>
#include <complex>
#include <cstdio>
#include <string>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  constexpr double friction = .5;

  /** Largest difference, column by column, of the derivative over 4 s to
   * difference quotients. */
  double
  derivative_error(const PeriodMap   &map,
                   const MotionState &start,
                   const unsigned int n_steps)
  {
    const Orbit            orbit = map.run(start, 4., n_steps);
    const std::vector<int> rows{0, 1, 2};
    const Eigen::MatrixXd  D =
      map.derivative(orbit, rows, StatusChanges::located);
    const Eigen::Index n = map.reduced_model().n_modes();
    Worst              worst;
    for (Eigen::Index k = 0; k < D.cols(); ++k)
      {
        const auto moved = [&](const double h) {
          MotionState s = start;
          (k < n       ? s.coordinates[k]
           : k < 2 * n ? s.velocities[k - n]
                       : s.forces[k - 2 * n]) += h;
          const MotionState e = map.run(s, 4., n_steps).end();
          Eigen::VectorXd   x(D.rows());
          x << e.coordinates, e.velocities, e.forces;
          return x;
        };
        const Eigen::VectorXd slope = (moved(1e-5) - moved(-1e-5)) / 2e-5;
        worst.add((slope - D.col(k)).norm() / std::max(D.col(k).norm(), 1e-3));
      }
    unsigned int n_open = 0, n_stick = 0;
    for (const auto &status : orbit.status)
      {
        n_open += status[0] == ContactStatus::open;
        n_stick += status[0] == ContactStatus::stick;
      }
    std::printf("derivative: %u open, %u sticking of %u, error %.2e\n",
                n_open,
                n_stick,
                n_steps,
                worst.largest());
    check(n_open > 0 && n_stick > 0, "the motion lifts off and sticks");
    return worst.largest();
  }

  void
  derivative(const ReducedContactModel &m)
  {
    const SteadySliding steady = steady_sliding(m, friction);
    const PeriodMap     map(m, friction, .3, 1., 1e-13);
    const MotionState   start  = later(map, disturbed(steady), 200., .02);
    const double        coarse = derivative_error(map, start, 200),
                 fine          = derivative_error(map, start, 1600);
    // Of second order in the mean: single steps depend on where changes lie.
    check_below(fine, coarse / 30., "derivative of the motion: second order");
    check_below(fine, 1e-4, "derivative of the motion");
  }

  /** Returns the largest beside the trivial one, which is off 1 by the square
   * of the step. */
  double
  multipliers(const PeriodMap      &map,
              const PeriodicMotion &x,
              ShootingSettings      settings,
              const std::string    &name)
  {
    double               largest = 0., coarsest = 0.;
    std::complex<double> last;
    for (const unsigned int factor : {1u, 2u, 4u, 8u})
      {
        ShootingSettings finer = settings;
        finer.n_steps *= factor;
        finer.tolerance            = 1e-9;
        const FloquetMultipliers f = floquet_multipliers(
          map, shoot(map, x.orbit.states.front(), x.period, finer));
        last    = f.trivial - 1.;
        largest = f.largest;
        if (factor == 1)
          coarsest = std::abs(last);
        std::printf("%s, %u steps: trivial multiplier %+.2e off 1, largest "
                    "other %.6f\n",
                    name.c_str(),
                    finer.n_steps,
                    last.real(),
                    f.largest);
      }
    check_below(coarsest, 1e-4, name + ": trivial multiplier");
    check_below(std::abs(last),
                std::max(coarsest / 30., 1e-6),
                name + ": trivial multiplier, second order");
    return largest;
  }

  /** A small disturbance decays by the largest multiplier a period: its
   * distance to the cycle after several. */
  void
  decay(const PeriodMap      &map,
        const PeriodicMotion &x,
        const double          largest,
        const std::string    &name)
  {
    const ReducedContactModel &m     = map.reduced_model();
    const MotionState         &start = x.orbit.states.front();
    MotionState                s     = start;
    s.velocities[0] += 1e-3;
    // Without what goes along the cycle: in equal steps it stays nearly as it
    // is.
    Eigen::VectorXd along(2 * m.n_modes());
    along << start.velocities.cwiseProduct(m.omega_squared.cwiseSqrt()),
      map.acceleration(start);
    along.normalize();
    std::vector<double> sizes;
    for (unsigned int i = 0; i <= 60; ++i)
      {
        Eigen::VectorXd d(2 * m.n_modes());
        d << (s.coordinates - start.coordinates)
               .cwiseProduct(m.omega_squared.cwiseSqrt()),
          s.velocities - start.velocities;
        sizes.push_back((d - along.dot(d) * along).norm());
        s = map.run(s, x.period, x.orbit.n_steps()).end();
      }
    // Over so many periods that the turning of the disturbance, whose
    // multiplier is complex, does not matter.
    const auto periods = [&](const double left) {
      return static_cast<unsigned int>(
        std::ceil(std::log(left) / std::log(largest)));
    };
    const unsigned int first = periods(.3), last = periods(1e-2);
    const double       found =
      std::pow(sizes[last] / sizes[first], 1. / (last - first));
    std::printf("%s: a disturbance decays by %.5f a period, the largest "
                "multiplier is %.5f\n",
                name.c_str(),
                found,
                largest);
    check_close(found, largest, .05, name + ": decay of a disturbance");
  }

  /** The law in slip and separation at equal parts of the period. */
  void
  harmonics(const ReducedContactModel &m,
            const PeriodicMotion      &x,
            const double               speed,
            const double               expected,
            const std::string         &name)
  {
    double         before = 0.;
    HarmonicMotion h      = harmonic_start(m, x);
    h.omega *= 1.01;
    for (const unsigned int n : {33u, 65u, 129u, 257u})
      {
        const HarmonicBalance balance(
          m, {Eigen::VectorXd::Constant(1, friction), {}, speed}, 1., n);
        h                                  = balance.solve(h);
        const double             frequency = h.omega / (2. * M_PI);
        const Eigen::RowVectorXd normal    = h.forces.row(0);
        const double             mean      = normal.mean(),
                     rms = std::sqrt((normal.array() - mean).square().mean());
        std::printf("%s, %u samples: %.6f Hz, rms %.6f N, residual %.1e, "
                    "between %.1e, imbalance %.1e, %u iterations\n",
                    name.c_str(),
                    n,
                    frequency,
                    rms,
                    h.residual,
                    balance.violation_between(h),
                    balance.ledger(h).imbalance(),
                    h.iterations);
        check(h.converged, name + ": harmonics converge");
        before = std::abs(frequency / expected - 1.);
      }
    check_below(before, 1e-3, name + ": frequency by harmonics");
  }

  void
  cycle(const ReducedContactModel &m,
        const double               speed,
        const std::string         &name)
  {
    const SteadySliding    steady = steady_sliding(m, friction);
    const LinearizedMotion linear = linearize(m, steady, friction, speed);
    Eigen::Index           k;
    std::printf("%s: sigma %.4f at %.4f rad/s\n",
                name.c_str(),
                linear.lambda.real().maxCoeff(&k),
                linear.lambda[k].imag());
    const PeriodMap map(m, friction, speed, 1., 1e-12);
    // A long transient in steps of 0.002, half of those of the cycle.
    const MotionState settled = later(map, disturbed(steady), 1500., .005);
    const Orbit       tail    = map.run(settled, 20., 10000);
    const auto        return_ = recurrences(m, tail, 2., 15.).back();
    std::printf("%s: recurrence %.6f s to %.1e\n",
                name.c_str(),
                return_.first,
                return_.second);
    const Orbit one =
      map.run(tail.end(), return_.first, std::lround(return_.first / .002));
    const Figures transient = figures_of(one);
    // Shooting from a state on the way there.
    ShootingSettings settings;
    settings.n_steps           = std::lround(return_.first / .004);
    const MotionState    early = later(map, disturbed(steady), 150., .02);
    const PeriodicMotion x = shoot(map, early, 1.02 * return_.first, settings);
    const Figures        s = figures_of(x.orbit);
    for (const double r : x.history)
      std::printf("  residual %.2e\n", r);
    std::printf("%s: transient %.6f Hz, rms %.6f N; shooting %.6f Hz, "
                "%.6f N, %u iterations\n",
                name.c_str(),
                transient.frequency,
                transient.rms,
                s.frequency,
                s.rms,
                x.iterations);
    check(x.status == CycleStatus::converged, name + ": shooting converges");
    check_close(s.frequency,
                transient.frequency,
                1e-4,
                name + ": frequency of shooting and transient");
    check_close(
      s.rms, transient.rms, 1e-3, name + ": rms of shooting and transient");
    const double largest = multipliers(map, x, settings, name);
    decay(map, x, largest, name);
    if (name != "sticking")
      harmonics(m, x, speed, transient.frequency, name);
  }

  /** What is found from starts far from a cycle, where Newton's method holds
   * the changes of status, is found again from itself: it is no motion that the
   * corrections of another one have made periodic. */
  void
  far_starts()
  {
    constexpr double          mu = .6, speed = 3.;
    const ReducedContactModel m      = two_modes(1., -.1);
    const SteadySliding       steady = steady_sliding(m, mu);
    const LinearizedMotion    linear = linearize(m, steady, mu, speed);
    const PeriodMap           map(m, mu, speed, 1., 1e-12);
    const Eigen::Index        n = steady.coordinates.size();
    // The pair at 1.0666 rad/s, without growth, at a large amplitude leads to
    // the unstable cycle beside it.
    Eigen::Index k = 0;
    (linear.lambda.imag().array() - 1.0666).abs().minCoeff(&k);
    const Eigen::VectorXd x = 2. * linear.right.col(k).real();
    ShootingSettings      settings;
    settings.tolerance = 1e-8;
    const PeriodicMotion cycle =
      shoot(map,
            {steady.coordinates + x.head(n), x.segment(n, n), steady.forces},
            .99 * 2. * M_PI / linear.lambda[k].imag(),
            settings);
    check(cycle.status == CycleStatus::converged &&
            floquet_multipliers(map, cycle).is_unstable(),
          "the unstable cycle is there");
    settings.n_steps     = 256;
    unsigned int n_found = 0;
    for (const auto &[at, longer] : {std::pair<unsigned int, double>{72, 1.02},
                                     {80, 1.02},
                                     {96, 1.},
                                     {104, 1.},
                                     {112, 1.}})
      {
        const MotionState &s     = cycle.orbit.states[at];
        const auto         moved = [](const Eigen::VectorXd &from,
                              const Eigen::VectorXd &to) {
          return Eigen::VectorXd(from + 1.5 * (to - from));
        };
        const PeriodicMotion found =
          shoot(map,
                {moved(steady.coordinates, s.coordinates),
                 1.5 * s.velocities,
                 moved(steady.forces, s.forces)},
                longer * cycle.period,
                settings);
        if (found.status != CycleStatus::converged)
          continue;
        ++n_found;
        const PeriodicMotion again =
          shoot(map, found.orbit.states.front(), found.period, settings);
        std::printf("from state %u: %.6f rad/s, held %d, again %.6f rad/s\n",
                    at,
                    2. * M_PI / found.period,
                    found.is_held,
                    2. * M_PI / again.period);
        check_close(
          found.period, again.period, 1e-5, "a motion is found again");
      }
    check(n_found >= 3, "motions are found from far away");
  }
} // namespace

int
main(int argc, char *argv[])
{
  const std::string which = argc > 1 ? argv[1] : "";
  if (which == "derivative")
    derivative(two_modes());
  else if (which == "derivative_coupled")
    derivative(two_coupled_modes());
  else if (which == "separating")
    cycle(two_modes(), 3., which);
  else if (which == "separating_coupled")
    cycle(two_coupled_modes(), 3., which);
  else if (which == "sticking")
    cycle(two_modes(), .3, which);
  else if (which == "far_starts")
    far_starts();
  else
    check(false,
          "an argument: derivative, separating (both with _coupled), sticking "
          "or far_starts");
}
