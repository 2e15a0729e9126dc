// SPDX-License-Identifier: LGPL-2.1-or-later

// Motion about steady sliding at lock-in, and at distances of 1e-4 to 1e-14
// from it: eigenmotions and the left vectors that pick their amplitudes
// satisfy their equations to rounding, nothing is infinite, and a pair's mean
// and squared half-difference are those of the closed form.

#include "check.h"
#include "transient/hand_made.h"

#include <squeal/transient/linearized_motion.h>

#include <cstdio>
#include <limits>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  using Complex = std::complex<double>;

  constexpr double eps = std::numeric_limits<double>::epsilon();

  /** Three modes on one contact spring, (rad/s)^2 in @p unit: with mu = 1 - d
   * K = unit [[2 + d, d, 0], [1, 2, 0], [0.7 mu, 0.7 mu, 5]], whose eigenvalues
   * are 5 unit and those of the pair, unit (2 + d/2 +- sqrt(d + d^2/4)):
   * lock-in at mu = 1. The third mode is damped critically: its two motions
   * have coalesced too. */
  struct ThreeModes
  {
    explicit ThreeModes(const double d)
      : friction(1. - d)
      , model(empty_model(1, 3))
    {
      model.omega_squared << 2. * unit, unit, 5. * unit;
      model.damping[2] = 2. * std::sqrt(5. * unit);
      model.participation.row(0) << 1., 1., 0.;
      model.participation.row(1) << -1., 0., .7;
      model.flexibility   = Eigen::MatrixXd::Identity(3, 3) / unit;
      sliding.coordinates = Eigen::VectorXd::Zero(3);
      sliding.motion      = Eigen::VectorXd::Zero(3);
      sliding.forces      = Eigen::Vector3d(100., 100. * friction, 0.);
      sliding.status      = {ContactStatus::slip};

      const double    d_exact = 1. - friction; // the one that is computed with
      const double    k       = .7 * friction;
      Eigen::MatrixXd K(3, 3);
      K << 2. + d_exact, d_exact, 0., 1., 2., 0., k, k, 5.;
      A = Eigen::MatrixXd::Zero(7, 7);
      A.block(0, 3, 3, 3).setIdentity();
      A.block(3, 0, 3, 3) = -unit * K;
      A(5, 5)             = -model.damping[2];
      A(6, 6)             = -unit * speed / (friction * 100.);
      mean                = 2. + d_exact / 2.;
      squared_half        = d_exact + d_exact * d_exact / 4.;
    }

    LinearizedMotion
    linearized() const
    {
      return linearize(model, sliding, friction, speed);
    }

    static constexpr double unit = 1e8, speed = .01;
    double                  friction, mean, squared_half;
    ReducedContactModel     model;
    SteadySliding           sliding;
    Eigen::MatrixXd         A;
  };

  /** Largest row or column residual, every entry over what it is made of:
   * displacements, velocities and forces have their own units. */
  double
  residual(const Eigen::VectorXcd &products,
           const Eigen::VectorXcd &expected,
           const Eigen::VectorXd  &sizes)
  {
    double worst = 0.;
    for (Eigen::Index i = 0; i < products.size(); ++i)
      {
        const double r =
          std::abs(products[i] - expected[i]) / std::max(sizes[i], 1e-300);
        if (!(r <= worst))
          worst = r;
      }
    return worst;
  }

  void
  test_distance(const double d)
  {
    char text[40];
    std::snprintf(text, sizeof(text), ", %g from lock-in", d);
    const ThreeModes       m(d);
    const LinearizedMotion l = m.linearized();
    check(l.lambda.size() == 5 || l.lambda.size() == 4,
          std::string("all motions") + text);
    check(l.left.allFinite() && l.right.allFinite() && l.condition.allFinite(),
          std::string("nothing infinite") + text);
    std::vector<Complex> pair;
    unsigned int         n_slips = 0;
    for (Eigen::Index k = 0; k < l.lambda.size(); ++k)
      {
        const Eigen::VectorXcd x = l.right.col(k);
        const Eigen::VectorXcd w = l.left.row(k).transpose();
        // Sizes of velocity times frequency stand for all of a motion: entries
        // that are zero are so but for rounding of the others.
        const Eigen::VectorXcd Ax = m.A * x, Aw = m.A.transpose() * w;
        Eigen::VectorXd        sizes_x = m.A.cwiseAbs() * x.cwiseAbs();
        Eigen::VectorXd sizes_w = m.A.transpose().cwiseAbs() * w.cwiseAbs();
        for (const int block : {0, 3})
          {
            sizes_x.segment(block, 3).setConstant(
              sizes_x.segment(block, 3).norm());
            sizes_w.segment(block, 3).setConstant(
              sizes_w.segment(block, 3).norm());
          }
        const Complex lambda = l.lambda[k];
        if (std::abs(lambda - m.A(6, 6)) <= 1e-12 * std::abs(m.A(6, 6)))
          {
            ++n_slips;
            continue;
          }
        check(residual(Ax.head(6), (lambda * x).head(6), sizes_x) <= 1e-13,
              std::string("A x = lambda x") + text);
        check(residual(Aw.head(6), (lambda * w).head(6), sizes_w) <= 1e-13,
              std::string("l A = lambda l") + text);
        const Complex kappa = -lambda * lambda / m.unit;
        if (std::abs(kappa + 5.) < 1.)
          {
            // Each by the root of rounding, their mean to rounding.
            check(std::abs(kappa + 5.) <= 1e-6,
                  std::string("critical damping") + text);
            check(l.condition[k] > 1e6 && l.condition[k] <= 1. / eps,
                  std::string("its condition") + text);
            continue;
          }
        pair.push_back(kappa);
        check(l.condition[k] >= 1. - 1e-12 && l.condition[k] <= 1. / eps,
              std::string("condition") + text);
        if (std::abs(d) >= 1e-8)
          check(std::abs((w.transpose() * x).value() - 1.) <= 1e-6,
                std::string("amplitude 1 of an eigenmotion") + text);
        else
          check(l.condition[k] > 1e3, std::string("large condition") + text);
      }
    check(n_slips == 1, std::string("slip across the sliding decays") + text);
    check(pair.size() == 2, std::string("both members") + text);
    const Complex mean = .5 * (pair[0] + pair[1]),
                  half = .5 * (pair[0] - pair[1]);
    check(std::abs(mean - m.mean) <= 1e-13,
          std::string("mean of the pair") + text);
    check(std::abs(half * half - m.squared_half) <= 1e-13,
          std::string("squared half-difference") + text);
  }
} // namespace



int
main()
{
  for (const double d :
       {1e-4, -1e-4, 1e-6, -1e-6, 1e-8, -1e-8, 1e-10, -1e-10, 1e-12, 1e-14, 0.})
    test_distance(d);
  return 0;
}
