// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Exceptional points of two oscillators of which one is damped: of friction
// that couples both, in closed form at a complex coefficient; none where the
// two cross without coupling or with one in one direction only.
#include <squeal/eigen/dense_quadratic.h>
#include <squeal/sweep/branch_tracker.h>
#include <squeal/sweep/stability.h>

#include "check.h"
#include "continued.h"

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
    pairs.error_estimate = pairs.noise_floor = Eigen::VectorXd::Zero(2);
    pairs.condition                          = Eigen::VectorXd::Ones(2);
    pairs.pair_partner.assign(2, -1);
    return pairs;
  }

  /** Along the line from -1 to 1. */
  template <typename Laws>
  std::vector<ExceptionalPoint>
  points_of(const Laws &laws, const unsigned int n)
  {
    TrackingOptions options;
    options.highest_frequency = 1.;
    options.real              = false;
    const auto solver         = [&](const double x) {
      return pairs_of(matrices(laws, x));
    };
    std::vector<double> coordinates;
    for (unsigned int i = 0; i <= n; ++i)
      coordinates.push_back(-1. + 2. * i / n);
    return LineStability(solver, options, 1e-8)
      .exceptional_points(
        BranchTracker(solver, options).track(coordinates),
        continued([&](const Complex z) { return matrices(laws, z); }));
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
} // namespace

int
main()
{
  coupled_by_friction();
  not_coupled();
}
