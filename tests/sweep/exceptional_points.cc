// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Exceptional points of two oscillators of which one is damped: of friction
// that couples both, in closed form at a complex coefficient; none where the
// two cross without coupling or with one in one direction only. Of undamped
// oscillators, every lock-in with the lock-out behind it, however near.
#include <squeal/eigen/dense_quadratic.h>
#include <squeal/sweep/branch_tracker.h>
#include <squeal/sweep/stability.h>

#include "check.h"
#include "continued.h"

#include <algorithm>
#include <cmath>
#include <string>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  using Complex = std::complex<double>;

  constexpr double dashpot = 0.06, k_1 = 1.02, k_2 = 1.;

  /** Of what couples the first equation to the second motion and the other way
   * round, and of what the first stiffness has in addition. */
  struct Law
  {
    Complex coupling_12, coupling_21, stiffer;
  };

  template <typename Laws>
  ContinuedMatrices
  matrices(const Laws &laws, const Complex z)
  {
    const Law         law  = laws(z);
    Eigen::MatrixXcd  zero = Eigen::MatrixXcd::Zero(2, 2);
    ContinuedMatrices m{zero, zero, zero};
    m.mass.setIdentity();
    m.damping(0, 0) = dashpot;
    m.stiffness << k_1 + law.stiffer, law.coupling_12, law.coupling_21, k_2;
    return m;
  }

  ComplexPairs
  pairs_of(const ContinuedMatrices &m)
  {
    const Eigen::MatrixXd M = m.mass.real(), C = m.damping.real(),
                          K = m.stiffness.real();
    const DensePairs d      = solve_dense_quadratic(
      {{M, {1., 0., 0.}}, {C, {0., 1., 0.}}, {K, {0., 0., 1.}}}, false, 0., 0.);
    ComplexPairs pairs;
    pairs.lambda         = d.lambda;
    pairs.right          = d.right;
    pairs.left           = d.left;
    const Eigen::Index n = d.lambda.size();
    pairs.error_estimate = pairs.noise_floor = Eigen::VectorXd::Zero(n);
    pairs.condition                          = Eigen::VectorXd::Ones(n);
    pairs.pair_partner.assign(n, -1);
    return pairs;
  }

  /** Along the line from @p from to @p to. */
  template <typename Matrices>
  std::vector<ExceptionalPoint>
  points_on(const Matrices    &matrices_at,
            const double       from,
            const double       to,
            const unsigned int n,
            const bool         is_real)
  {
    TrackingOptions options;
    options.highest_frequency = 1.;
    options.real              = is_real;
    const auto solver         = [&](const double x) {
      return pairs_of(matrices_at(x));
    };
    std::vector<double> coordinates;
    for (unsigned int i = 0; i <= n; ++i)
      coordinates.push_back(from + (to - from) * i / n);
    return LineStability(solver, options, 1e-8)
      .exceptional_points(BranchTracker(solver, options).track(coordinates),
                          continued(matrices_at));
  }

  template <typename Laws>
  std::vector<ExceptionalPoint>
  points_of(const Laws &laws, const unsigned int n)
  {
    return points_on(
      [&](const Complex z) { return matrices(laws, z); }, -1., 1., n, false);
  }

  /** a b = p with a double root: (a b)' = 0 where a and b are lambda^2 + c
   * lambda + k of the two motions and p is the product of the couplings. */
  void
  coupled_by_friction()
  {
    Complex lambda(-0.25 * dashpot, 1.), product;
    for (int step = 0; step < 50; ++step)
      {
        const Complex a  = lambda * lambda + dashpot * lambda + k_1,
                      da = 2. * lambda + dashpot, b = lambda * lambda + k_2,
                      db = 2. * lambda;
        product          = a * b;
        lambda -= (da * b + a * db) / (2. * b + 2. * da * db + 2. * a);
      }
    // The second equation has (0.1 - z / 5) y_1, the first one y_2 / 10.
    const Complex truth = 5. * (0.1 - 10. * product);
    check(std::abs(truth.imag()) > 0.01, "the point is off the real axis");
    for (const unsigned int n : {3u, 8u, 31u})
      {
        const auto found = points_of(
          [](const Complex z) {
            return Law{0.1, 0.1 - z / 5., 0.};
          },
          n);
        const std::string with = " with " + std::to_string(n) + " steps";
        check(found.size() == 1, "one point" + with);
        check(std::abs(found[0].coordinate - truth) < 1e-6,
              "its coordinate" + with);
        check_close(2. * M_PI * found[0].frequency,
                    lambda.imag(),
                    1e-6,
                    "its frequency" + with);
        check_close(
          found[0].sigma, lambda.real(), 1e-6, "its growth rate" + with);
      }
  }

  /** The frequencies cross on the line, the damped pair far from the other one
   * in growth rate, so that the real part of the squared difference changes its
   * sign. The eigenvalues are one at a complex stiffness, each with a vector of
   * its own, or with one vector and no way to turn into each other. */
  void
  not_coupled()
  {
    for (const double one_way : {0., 0.05})
      for (const unsigned int n : {3u, 8u, 31u})
        check(points_of(
                [=](const Complex z) {
                  return Law{one_way, 0., 0.5 * z};
                },
                n)
                .empty(),
              std::string("no point of a crossing ") +
                (one_way == 0. ? "without coupling"
                               : "with coupling in one direction"));
  }

  /** Lock-ins and lock-outs in turn at @p truth. */
  void
  in_and_out(std::vector<ExceptionalPoint> found,
             const std::vector<double>    &truth,
             const double                  tolerance,
             const std::string            &of_what)
  {
    std::sort(found.begin(), found.end(), [](const auto &a, const auto &b) {
      return a.coordinate.real() < b.coordinate.real();
    });
    check(found.size() == truth.size(),
          std::to_string(found.size()) + " points " + of_what);
    for (std::size_t i = 0; i < truth.size(); ++i)
      {
        check(found[i].is_lock_in == (i % 2 == 0), "in and out " + of_what);
        check(std::abs(found[i].coordinate - truth[i]) < tolerance,
              "the coordinate " + of_what);
      }
  }

  /** Stiffnesses 1 and s that friction c couples: from s = 1 - 2 c to 1 + 2 c.
   * Of three with couplings next to two crossings, four points, which are
   * where the discriminant of the cubic in lambda^2 changes its sign. */
  void
  lock_out_behind_lock_in()
  {
    for (const double c : {0.009, 0.003, 9e-4, 3e-4, 3e-5})
      for (const unsigned int n : {1u, 3u, 8u})
        in_and_out(points_on(
                     [c](const Complex s) {
                       const Eigen::MatrixXcd zero =
                         Eigen::MatrixXcd::Zero(2, 2);
                       ContinuedMatrices m{zero, zero, zero};
                       m.mass.setIdentity();
                       m.stiffness << 1., c, -c, s;
                       return m;
                     },
                     0.5,
                     1.7,
                     n,
                     true),
                   {1. - 2. * c, 1. + 2. * c},
                   1e-9,
                   "of friction " + std::to_string(c));
    for (const unsigned int n : {1u, 2u, 4u, 10u, 20u})
      in_and_out(
        points_on(
          [](const Complex s) {
            const Eigen::MatrixXcd zero = Eigen::MatrixXcd::Zero(3, 3);
            ContinuedMatrices      m{zero, zero, zero};
            m.mass.setIdentity();
            m.stiffness << 0.99, 0., 0.002, 0., 1.01, 0.0025, -0.002, -0.0025,
              s;
            return m;
          },
          0.5,
          1.5,
          n,
          true),
        {0.985715992910, 0.993652589495, 1.005228678956, 1.015177738639},
        1e-9,
        "of three oscillators with " + std::to_string(n) + " steps");
  }
} // namespace

int
main()
{
  coupled_by_friction();
  not_coupled();
  lock_out_behind_lock_in();
}
