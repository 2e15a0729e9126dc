// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Branches of small systems of known behaviour: two lock-ins, a crossing, a
// doublet, an exceptional point off the real axis.
#include <Eigen/LU>

#include <squeal/eigen/dense_quadratic.h>
#include <squeal/sweep/branch_tracker.h>
#include <squeal/sweep/stability.h>

#include "check.h"
#include "continued.h"
#include "worst.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  ComplexPairs
  solve(const Eigen::MatrixXd &K, const Eigen::MatrixXd &C)
  {
    const Eigen::Index    n = K.rows();
    const Eigen::MatrixXd M = Eigen::MatrixXd::Identity(n, n);
    const DensePairs      d = solve_dense_quadratic(
      {{M, {1., 0., 0.}}, {C, {0., 1., 0.}}, {K, {0., 0., 1.}}}, false, 0., 0.);
    ComplexPairs pairs;
    pairs.lambda         = d.lambda;
    pairs.right          = d.right;
    pairs.left           = d.left;
    pairs.error_estimate = pairs.noise_floor =
      Eigen::VectorXd::Zero(d.lambda.size());
    pairs.pair_partner.assign(d.lambda.size(), -1);
    pairs.condition.resize(d.lambda.size());
    for (Eigen::Index i = 0; i < d.lambda.size(); ++i)
      pairs.condition[i] =
        2. * std::abs(d.lambda[i]) /
        std::abs((d.left.col(i).transpose() *
                  (2. * d.lambda[i] * d.right.col(i) + C * d.right.col(i)))(0));
    return pairs;
  }

  /** Frequencies 1 + t/2 and 2 - t/2 lock in about t = 1; one at 1.2 crosses
   * the first of them without coupling, one at 3 stands apart, a doublet at 4.
   */
  template <typename Number>
  Eigen::Matrix<Number, Eigen::Dynamic, Eigen::Dynamic>
  chain_stiffness(const Number t)
  {
    Eigen::Matrix<Number, Eigen::Dynamic, Eigen::Dynamic> K;
    K.setZero(6, 6);
    K.diagonal() << (1. + 0.5 * t) * (1. + 0.5 * t),
      (2. - 0.5 * t) * (2. - 0.5 * t), 1.44, 9., 16., 16.;
    K(0, 1) = 0.1;
    K(1, 0) = -0.1;
    return K;
  }

  ComplexPairs
  chain(const double t, const double damping = 0.)
  {
    const Eigen::MatrixXd K = chain_stiffness(t);
    Eigen::MatrixXd       C = 1e-3 * K;
    C(0, 0) += damping;
    return solve(K, C);
  }

  TrackingOptions
  options(const bool real = true)
  {
    TrackingOptions o;
    o.lowest_frequency  = 0.;
    o.highest_frequency = 1.;
    o.real              = real;
    return o;
  }

  std::vector<double>
  steps(const double from, const double to, const unsigned int n)
  {
    std::vector<double> result;
    for (unsigned int i = 0; i <= n; ++i)
      result.push_back(from + (to - from) * i / n);
    return result;
  }

  int
  branch_near(const TrackedPoint &p, const double frequency)
  {
    int best = 0;
    for (unsigned int i = 0; i < p.pairs.size(); ++i)
      if (std::abs(p.pairs.frequency(i) - frequency) <
          std::abs(p.pairs.frequency(best) - frequency))
        best = i;
    return p.branch[best];
  }

  void
  random_walk()
  {
    const auto    solver = [](const double t) { return chain(t); };
    BranchTracker straight(solver, options());
    // Through the crossing (t = 0.4) and the lock-in (t = 1).
    const auto line = straight.track(steps(0., 2., 400));

    std::mt19937                           generator(5);
    std::uniform_real_distribution<double> step(-0.3, 0.3);
    std::vector<double>                    places = {0.};
    while (places.size() <= 200)
      places.push_back(
        std::clamp(places.back() + step(generator) * 1., 0., 2.));
    const auto place = [&](const double s) {
      const std::size_t i =
        std::min<std::size_t>(static_cast<std::size_t>(s), places.size() - 2);
      return places[i] + (s - i) * (places[i + 1] - places[i]);
    };
    BranchTracker walk([&](const double s) { return chain(place(s)); },
                       options());
    const auto    walked  = walk.track(steps(0., 200., 200));
    unsigned int  n_wrong = 0, n_judged = 0;
    for (const auto &p : walked)
      {
        if (!p.asked)
          continue;
        // The nearest point of the straight line.
        const double t    = place(p.coordinate);
        const auto  *near = &line.front();
        for (const auto &q : line)
          if (std::abs(q.coordinate - t) < std::abs(near->coordinate - t))
            near = &q;
        for (const int b : {branch_near(line[0], 1. / (2. * M_PI)),
                            branch_near(line[0], 2. / (2. * M_PI)),
                            branch_near(line[0], 1.2 / (2. * M_PI)),
                            branch_near(line[0], 3. / (2. * M_PI))})
          {
            const int i = p.pair_of(b), j = near->pair_of(b);
            ++n_judged;
            // Near the lock-in lambda changes like a square root.
            n_wrong += i < 0 || j < 0 ||
                       std::abs(p.pairs.lambda[i] - near->pairs.lambda[j]) >
                         0.5 * std::sqrt(0.005);
          }
      }
    check(n_judged == 4 * 201, "every step of the walk was judged");
    check(n_wrong == 0,
          "a walk of 200 steps swaps no branch (" + std::to_string(n_wrong) +
            ")");
    bool                       crossed = false;
    const std::complex<double> still =
      line.back().pairs.lambda[line.back().pair_of(
        branch_near(line[0], 1.2 / (2. * M_PI)))];
    crossed = std::abs(still.imag() - 1.2) < 1e-3;
    check(crossed, "the uncoupled branch crosses the others");
  }

  void
  tiny_steps()
  {
    // The coalescence, then straight through it at steps of 1e-8.
    const auto    solver = [](const double t) { return chain(t); };
    BranchTracker coarse(solver, options());
    const auto    line = coarse.track(steps(0.6, 1.4, 40));
    const auto    points =
      LineStability(solver, options(), 1e-9)
        .exceptional_points(line, continued([](const std::complex<double> z) {
                              const Eigen::MatrixXcd K = chain_stiffness(z);
                              return ContinuedMatrices{
                                Eigen::MatrixXcd::Identity(6, 6), 1e-3 * K, K};
                            }));
    check(points.size() == 2, "one lock-in and one lock-out");
    check(points[0].is_lock_in && !points[1].is_lock_in, "in that order");
    // Closed form: (k_1 - k_2)^2 / 4 = 0.01 with k = frequency squared.
    const double t = points[0].coordinate.real();
    const double half =
      0.5 * (std::pow(1. + 0.5 * t, 2) - std::pow(2. - 0.5 * t, 2));
    check_close(half * half, 0.01, 1e-7, "place of the lock-in");
    check(std::abs(points[0].coordinate.imag()) < 1e-7,
          "on the real axis with proportional damping");

    BranchTracker fine(solver, options());
    const auto    through = fine.track(steps(t - 5e-7, t + 5e-7, 100));
    const int     a = branch_near(through.front(), (1. + 0.5 * t) / 2. / M_PI);
    int           b = -1;
    for (unsigned int i = 0; i < through.front().pairs.size(); ++i)
      if (through.front().branch[i] != a &&
          std::abs(
            through.front().pairs.frequency(i) -
            through.front().pairs.frequency(through.front().pair_of(a))) < 1e-3)
        b = through.front().branch[i];
    Worst condition;
    for (const auto &p : through)
      {
        check(p.pair_of(a) >= 0 && p.pair_of(b) >= 0,
              "the invariant pair stays paired at " +
                std::to_string(p.coordinate - t));
        condition.add(p.pairs.condition[p.pair_of(a)]);
      }
    check(condition.largest() > 1e3, "the condition of the eigenvalue tells");
    check(through.front().pairs.frequency(through.front().pair_of(b)) >
            through.front().pairs.frequency(through.front().pair_of(a)),
          "two frequencies before");
    check(through.back().pairs.sigma(through.back().pair_of(b)) >
            through.back().pairs.sigma(through.back().pair_of(a)),
          "two rates behind, the upper branch with the larger one");
  }

  void
  closed_loop()
  {
    // Two oscillators, one of them damped: their eigenvalues coalesce where the
    // frequencies agree and the coupling is half the damping times the
    // frequency, a point in the plane of t and the coupling.
    const auto pairs_at = [](const double t, const double coupling) {
      Eigen::MatrixXd K(2, 2), C = Eigen::MatrixXd::Zero(2, 2);
      K << std::pow(1. + 0.5 * t, 2), coupling, coupling,
        std::pow(2. - 0.5 * t, 2);
      C(0, 0) = 0.05;
      return solve(K, C);
    };
    const auto square = [&](const Eigen::Vector2d &p) {
      const ComplexPairs         q = pairs_at(p[0], p[1]);
      const std::complex<double> d = 0.5 * (q.lambda[0] - q.lambda[1]);
      return d * d;
    };
    Eigen::Vector2d p(0.99, 0.03);
    for (unsigned int step = 0; step < 40; ++step)
      {
        const double               h = 1e-6;
        const std::complex<double> f = square(p);
        Eigen::Matrix2d            J;
        for (int k = 0; k < 2; ++k)
          {
            Eigen::Vector2d q = p;
            q[k] += h;
            const std::complex<double> d = (square(q) - f) / h;
            J.col(k) << d.real(), d.imag();
          }
        p -= J.inverse() * Eigen::Vector2d(f.real(), f.imag());
      }
    check(std::abs(square(p)) < 1e-9, "exceptional point of the plane");
    const auto exchanged = [&](const Eigen::Vector2d &centre, const double r) {
      BranchTracker tracker(
        [&](const double s) {
          return pairs_at(centre[0] + r * std::cos(2. * M_PI * s),
                          centre[1] + r * std::sin(2. * M_PI * s));
        },
        options(false));
      const auto loop = tracker.track(steps(0., 1., 16));
      return loop_permutation(loop.front(), loop.back(), options(false))[0] ==
             1;
    };
    check(exchanged(p, 0.01), "a loop round the point exchanges the branches");
    check(!exchanged(p + Eigen::Vector2d(0.05, 0.), 0.01),
          "a loop beside it does not");
  }

  void
  doublets()
  {
    BranchTracker tracker([](const double t) { return chain(t); }, options());
    const auto    line = tracker.track(steps(0., 0.3, 6));
    check(tracker.n_inserted() < 40, "a doublet asks for no endless division");
    const int b = line.front().branch.back();
    check(line.back().pair_of(b) >= 0 &&
            std::abs(line.back().pairs.frequency(line.back().pair_of(b)) -
                     4. / (2. * M_PI)) < 1e-4,
          "a member of a doublet stays one");
  }

  /** Where nothing is like what it was, points are not inserted for ever. */
  void
  never_certain()
  {
    std::mt19937    generator(1);
    TrackingOptions bounded = options();
    bounded.most_inserted   = 60;
    BranchTracker tracker(
      [&](const double) {
        const Eigen::MatrixXd Q =
          Eigen::MatrixXd::NullaryExpr(
            6,
            6,
            [&]() {
              return std::uniform_real_distribution<double>(-1., 1.)(generator);
            })
            .householderQr()
            .householderQ();
        const Eigen::VectorXd kappa =
          Eigen::VectorXd::LinSpaced(6, 1., 4.).cwiseAbs2();
        return solve(Q * kappa.asDiagonal() * Q.transpose(),
                     Eigen::MatrixXd::Zero(6, 6));
      },
      bounded);
    const auto line = tracker.track(steps(0., 1., 10));
    check(tracker.n_inserted() >= 60 && tracker.n_inserted() < 120,
          "not for ever, but " + std::to_string(tracker.n_inserted()));
    check(line.size() == 11 + tracker.n_inserted(), "all points are there");
  }

  void
  ranges_and_edges()
  {
    // The lock-in of chain() without damping: sigma = 0 at the coalescence.
    const auto solver = [](const double t) {
      ComplexPairs p = chain(t, 0.);
      return p;
    };
    BranchTracker tracker(solver, options());
    const auto    line   = tracker.track(steps(0., 2., 20));
    const auto    ranges = LineStability(solver, options(), 1e-7).ranges(line);
    check(ranges.size() == 1, "one unstable range");
    check(!ranges[0].at_lower_limit && !ranges[0].at_upper_limit, "inside");
    // sigma = -beta kappa / 2 + Im(sqrt(kappa)): from the solution itself.
    for (const double x : {ranges[0].lower, ranges[0].upper})
      {
        const ComplexPairs p = chain(x);
        check(p.lambda.real().maxCoeff<Eigen::PropagateNaN>() < 2e-5 &&
                p.lambda.real().maxCoeff<Eigen::PropagateNaN>() > -2e-3,
              "sigma vanishes at the edge");
      }
    Worst best;
    for (const double t : steps(ranges[0].lower, ranges[0].upper, 20000))
      best.add(chain(t).lambda.real().maxCoeff<Eigen::PropagateNaN>());
    check_close(ranges[0].peak_sigma, best.largest(), 1e-6, "peak of sigma");

    // A range much narrower than the steps is not missed.
    const auto narrow = [](const double t) {
      Eigen::MatrixXd K(2, 2);
      K << std::pow(1. + 0.5 * t, 2), 1e-4, -1e-4, std::pow(2. - 0.5 * t, 2);
      return solve(K, Eigen::MatrixXd::Zero(2, 2));
    };
    BranchTracker second(narrow, options());
    const auto    found = LineStability(narrow, options(), 1e-7)
                         .ranges(second.track(steps(0., 2.03, 17)));
    check(found.size() == 1 && found[0].upper - found[0].lower < 3e-4,
          "a range of 1e-4 between steps of 0.1 is found");
  }
  /** An oscillator of stiffness k beside one of stiffness 4 with a coupling as
   * friction makes it: det K = 4 k + 0.01 is negative where it diverges. */
  ComplexPairs
  diverging(const double k, const double damping)
  {
    Eigen::MatrixXd K(2, 2);
    K << k, 0.1, -0.1, 4.;
    return solve(K, damping * Eigen::MatrixXd::Identity(2, 2));
  }

  void
  divergence(const double damping)
  {
    const std::string with      = " with damping " + std::to_string(damping);
    const auto        ranges_of = [&](const std::function<double(double)> &k) {
      const auto solver = [&](const double t) {
        return diverging(k(t), damping);
      };
      BranchTracker tracker(solver, options());
      const auto    line = tracker.track(steps(-2., 2., 16));
      return LineStability(solver, options(), 1e-8).ranges(line);
    };
    // The damping does not move the edge, at which the stiffness is singular.
    const auto below = ranges_of([](const double t) { return t; });
    check(below.size() == 1 && below[0].at_lower_limit &&
            !below[0].at_upper_limit && below[0].lower == -2.,
          "divergence up to an edge is one range" + with);
    check_close(below[0].upper, -0.0025, 1e-4, "its edge: det K = 0" + with);
    // lambda^2 + c lambda + kappa = 0 with the lower eigenvalue kappa of K
    const double kappa = 0.5 * (2. - std::sqrt(36. - 0.04));
    check_close(below[0].peak_sigma,
                -0.5 * damping + std::sqrt(0.25 * damping * damping - kappa),
                1e-9,
                "its growth rate at the end of the axis" + with);
    check(below[0].peak_frequency == 0., "it does not oscillate" + with);

    const auto middle = ranges_of([](const double t) { return t * t - 1.; });
    check(middle.size() == 1 && !middle[0].at_lower_limit &&
            !middle[0].at_upper_limit,
          "divergence between two edges is one range" + with);
    const double edge = std::sqrt(1. - 0.0025);
    check_close(middle[0].lower, -edge, 1e-6, "its lower edge" + with);
    check_close(middle[0].upper, edge, 1e-6, "its upper edge" + with);
  }

  /** A flutter whose frequency rises along the axis, out of the band at the top
   * and into it at the bottom: no end of the axis. */
  void
  out_of_the_band()
  {
    TrackingOptions band   = options();
    band.lowest_frequency  = 0.2;
    band.highest_frequency = 0.6;
    const auto solver      = [&](const double t) {
      Eigen::MatrixXd K(2, 2);
      K << 1., 0.1, -0.1, 1.;
      const double     scale = std::pow(2. * M_PI * t, 2);
      const auto       all   = solve(scale * K, Eigen::MatrixXd::Zero(2, 2));
      std::vector<int> kept;
      for (unsigned int i = 0; i < all.size(); ++i)
        if (all.frequency(i) >= band.lowest_frequency &&
            all.frequency(i) <= band.highest_frequency)
          kept.push_back(i);
      ComplexPairs pairs   = all;
      const auto   n       = static_cast<Eigen::Index>(kept.size());
      pairs.lambda         = all.lambda(kept);
      pairs.right          = all.right(Eigen::all, kept);
      pairs.left           = all.left(Eigen::all, kept);
      pairs.error_estimate = pairs.noise_floor = Eigen::VectorXd::Zero(n);
      pairs.condition                          = all.condition(kept);
      pairs.pair_partner.assign(n, -1);
      return pairs;
    };
    const auto range_of = [&](const double from, const double to) {
      BranchTracker tracker(solver, band);
      const auto    line   = tracker.track(steps(from, to, 16));
      const auto    ranges = LineStability(solver, band, 1e-7).ranges(line);
      check(ranges.size() == 1, "one range of the flutter");
      return ranges[0];
    };
    const UnstableRange inside = range_of(0.3, 0.5);
    check(inside.at_lower_limit && inside.at_upper_limit &&
            !inside.leaves_band_below && !inside.leaves_band_above,
          "within the band it ends with the axis");
    const UnstableRange up = range_of(0.3, 0.9);
    check(up.at_lower_limit && !up.leaves_band_below,
          "it begins with the axis");
    check(!up.at_upper_limit && up.leaves_band_above && !up.has_upper_edge(),
          "and leaves the band, which is no end of the axis");
    check(up.upper_slope == 0., "there is no edge with a slope");
    const double frequency = std::sqrt(std::complex<double>(1., .1)).real();
    check_close(up.upper, .6 / frequency, 1e-6, "where it leaves the band");
    const UnstableRange down = range_of(0.1, 0.5);
    check(!down.at_lower_limit && down.leaves_band_below &&
            !down.has_lower_edge() && down.at_upper_limit,
          "nor is where it comes into the band");
    check_close(down.lower, .2 / frequency, 1e-6, "which is told");
  }

  /** Two oscillators, lock-in where their frequencies 1 + t/2 and 2 - t/2, in
   * rad/s, agree: (3 - 3 t)^2 = 4 * 0.1^2. Only pairs up to @p highest, Hz, are
   * seen. */
  ComplexPairs
  lock_in(const double t, const double highest)
  {
    Eigen::MatrixXd K(2, 2);
    K << std::pow(1. + 0.5 * t, 2), 0.1, -0.1, std::pow(2. - 0.5 * t, 2);
    const auto       all = solve(K, Eigen::MatrixXd::Zero(2, 2));
    std::vector<int> kept;
    for (unsigned int i = 0; i < all.size(); ++i)
      if (all.frequency(i) <= highest)
        kept.push_back(i);
    ComplexPairs pairs   = all;
    const auto   n       = static_cast<Eigen::Index>(kept.size());
    pairs.lambda         = all.lambda(kept);
    pairs.right          = all.right(Eigen::all, kept);
    pairs.left           = all.left(Eigen::all, kept);
    pairs.error_estimate = pairs.noise_floor = Eigen::VectorXd::Zero(n);
    pairs.condition                          = all.condition(kept);
    pairs.pair_partner.assign(n, -1);
    return pairs;
  }

  /** Pairs up to 0.5 Hz have the same ranges in a band up to 1 Hz and up to
   * 20 Hz, of which they are in the lowest 3 per cent: nothing leaves a band at
   * 0 Hz. Six oscillators each that other couplings drive, at five points. */
  void
  near_zero()
  {
    unsigned int n_edges = 0, n_other = 0;
    Worst        difference;
    for (unsigned int seed = 1; seed <= 20; ++seed)
      {
        std::mt19937                     generator(seed);
        std::normal_distribution<double> normal;
        Eigen::MatrixXd                  A(6, 6), B(6, 6);
        for (Eigen::Index i = 0; i < 36; ++i)
          {
            A(i) = normal(generator);
            B(i) = normal(generator);
          }
        const Eigen::MatrixXd K =
          A * A.transpose() / 6. + Eigen::MatrixXd::Identity(6, 6);
        const auto solver = [&](const double t) {
          return solve(K + 0.4 * t * B, Eigen::MatrixXd::Zero(6, 6));
        };
        const auto ranges_to = [&](const double highest) {
          TrackingOptions band   = options();
          band.highest_frequency = highest;
          BranchTracker tracker(solver, band);
          return LineStability(solver, band, 1e-8)
            .ranges(tracker.track(steps(-1., 1., 4)));
        };
        const auto narrow = ranges_to(1.), wide = ranges_to(20.);
        n_other += narrow.size() != wide.size();
        for (std::size_t r = 0; r < narrow.size() && r < wide.size(); ++r)
          {
            n_other += narrow[r].has_lower_edge() != wide[r].has_lower_edge() ||
                       narrow[r].has_upper_edge() != wide[r].has_upper_edge();
            n_edges += narrow[r].has_lower_edge() + narrow[r].has_upper_edge();
            difference.add(std::abs(narrow[r].lower - wide[r].lower));
            difference.add(std::abs(narrow[r].upper - wide[r].upper));
          }
      }
    check(n_edges >= 20, std::to_string(n_edges) + " edges in two bands");
    check(n_other == 0, "the ranges are the same ones");
    check_within(difference, 1e-6, "and have the same edges");
  }

  /** A lock-in within 3 per cent of the band's width of an edge has the edges
   * that it has in the middle of a band. */
  void
  near_an_edge(const double              highest,
               const std::vector<double> coordinates,
               const std::string        &where)
  {
    TrackingOptions band   = options();
    band.highest_frequency = highest;
    const auto    solver = [&](const double t) { return lock_in(t, highest); };
    BranchTracker tracker(solver, band);
    const auto    line   = tracker.track(coordinates);
    const auto    ranges = LineStability(solver, band, 1e-8).ranges(line);
    check(ranges.size() == 1, "one range " + where);
    check(ranges[0].has_lower_edge() && ranges[0].has_upper_edge(),
          "which does not leave the band " + where);
    check_close(ranges[0].lower, 14. / 15., 1e-6, "its lower edge " + where);
    check_close(ranges[0].upper, 16. / 15., 1e-6, "its upper edge " + where);
    check(tracker.n_inserted() < 150,
          "by " + std::to_string(tracker.n_inserted()) + " more points");
  }
} // namespace

int
main()
{
  near_zero();
  // 1.505 rad/s, where the two lock in at 1.5004 rad/s
  near_an_edge(1.505 / (2. * M_PI),
               steps(0.865, 1.135, 9),
               "at the upper edge of the band");
  out_of_the_band();
  random_walk();
  tiny_steps();
  closed_loop();
  doublets();
  never_certain();
  ranges_and_edges();
  // damped a little, and overdamped next to the edge
  divergence(1e-3);
  divergence(0.5);
}
