// SPDX-License-Identifier: LGPL-2.1-or-later

// Motions about steady sliding where the modes leave little of the bodies, as
// on coarse meshes and in condensed matrices whose modes lie below the cut-off:
// the flexibility of the contact is rounding, wholly or in most motions, and
// the modes keep what a closed node keeps. They are those on a flexibility that
// is there and small.

#include "check.h"
#include "transient/hand_made.h"
#include "worst.h"

#include <squeal/transient/linearized_motion.h>
#include <squeal/transient/steady_sliding.h>

#include <algorithm>
#include <random>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  constexpr unsigned int n_nodes = 3, n_modes = 16;
  constexpr double       mu = .3, speed = .1, highest = 1e5;

  /** Modes from 80 Hz to 8 kHz that move three nodes in all directions. */
  ReducedContactModel
  model_of_modes()
  {
    std::minstd_rand                 generator(7);
    std::normal_distribution<double> random;
    ReducedContactModel              m = empty_model(n_nodes, n_modes);
    for (unsigned int k = 0; k < n_modes; ++k)
      m.omega_squared[k] =
        std::pow(2. * M_PI * 80. * std::pow(100., k / (n_modes - 1.)), 2);
    m.damping       = 2e-2 * m.omega_squared.cwiseSqrt();
    m.participation = Eigen::MatrixXd::NullaryExpr(
      3 * n_nodes, n_modes, [&](int, int) { return random(generator); });
    m.cut_off = 4e4;
    return m;
  }

  /** What is left of responses that agree but for their last digits, m/N. */
  Eigen::MatrixXd
  rounding(const ReducedContactModel &m)
  {
    std::minstd_rand                 generator(11);
    std::normal_distribution<double> random;
    const double                     size =
      1e-16 * largest_abs(Eigen::MatrixXd(m.participation.cwiseAbs2() *
                                          m.omega_squared.cwiseInverse()));
    const Eigen::MatrixXd R =
      Eigen::MatrixXd::NullaryExpr(3 * n_nodes, 3 * n_nodes, [&](int, int) {
        return size * random(generator);
      });
    return R + R.transpose();
  }

  /** All nodes slip, but for the first one with @p sticks. */
  SteadySliding
  all_closed(const bool sticks)
  {
    SteadySliding about;
    about.coordinates = Eigen::VectorXd::Zero(n_modes);
    about.forces      = Eigen::VectorXd::Zero(3 * n_nodes);
    about.motion      = Eigen::VectorXd::Zero(3 * n_nodes);
    about.status.assign(n_nodes, ContactStatus::slip);
    for (unsigned int j = 0; j < n_nodes; ++j)
      {
        about.forces[3 * j]     = 20. + j;
        about.forces[3 * j + 1] = mu * about.forces[3 * j];
      }
    if (sticks)
      about.status[0] = ContactStatus::stick;
    return about;
  }

  /** Ascending, 1/s, above 0 and below `highest`. */
  std::vector<std::complex<double>>
  motions(const LinearizedMotion &linear)
  {
    std::vector<std::complex<double>> result;
    for (const auto &lambda : linear.lambda)
      if (lambda.imag() > 0. && lambda.imag() < highest)
        result.push_back(lambda);
    return result;
  }

  /** Largest rate of a motion, 1/s. */
  double
  fastest(const LinearizedMotion &linear)
  {
    return largest(linear.lambda.real());
  }

  /** Little enough for motions of the band, m/N; more where a dashpot acts, as
   * the force of a stiff one fades so fast that its rate takes the digits. */
  Eigen::MatrixXd
  of_contact(const SteadySliding &about)
  {
    Eigen::VectorXd result = Eigen::VectorXd::Constant(3 * n_nodes, 1e-15);
    for (unsigned int j = 0; j < n_nodes; ++j)
      if (about.status[j] == ContactStatus::slip)
        result[3 * j + 2] = 1e-12;
    return result.asDiagonal();
  }

  void
  compare(const Eigen::MatrixXd &flexible,
          const bool             sticks,
          const std::string     &text)
  {
    ReducedContactModel rigid = model_of_modes(), nearly = rigid;
    rigid.flexibility               = flexible + rounding(rigid);
    const SteadySliding about       = all_closed(sticks);
    nearly.flexibility              = flexible + of_contact(about);
    const LinearizedMotion found    = linearize(rigid, about, mu, speed),
                           expected = linearize(nearly, about, mu, speed);
    const auto a = motions(found), b = motions(expected);
    check(!a.empty() && a.size() == b.size(),
          text + ": " + std::to_string(a.size()) + " of " +
            std::to_string(b.size()) + " motions");
    Worst off;
    for (std::size_t i = 0; i < a.size() && i < b.size(); ++i)
      off.add(std::abs(a[i] - b[i]) / std::abs(b[i]));
    check(off.largest() < 1e-5,
          "motions, " + text + ": " + std::to_string(off.largest()));
    check(fastest(found) < 1e4, "no rate is rounding, " + text);
    Worst residual;
    for (Eigen::Index k = 0; k < found.lambda.size(); ++k)
      residual.add(
        std::abs((found.left.row(k) * found.right.col(k)).value() - 1.));
    check(residual.largest() < 1e-6,
          "left eigenvectors pick their motion, " + text);
  }

  /** What moves some of the nodes together, m/N. */
  Eigen::MatrixXd
  of_few_motions(const unsigned int n)
  {
    std::minstd_rand                 generator(5);
    std::normal_distribution<double> random;
    const Eigen::MatrixXd            modes = Eigen::MatrixXd::NullaryExpr(
      3 * n_nodes, n, [&](int, int) { return 1e-5 * random(generator); });
    return modes * modes.transpose();
  }
} // namespace



int
main()
{
  for (const bool sticks : {false, true})
    {
      const std::string text = sticks ? ", a node sticking" : ", all slipping";
      compare(Eigen::MatrixXd::Zero(3 * n_nodes, 3 * n_nodes),
              sticks,
              "on no flexibility" + text);
      for (const unsigned int n : {1u, 2u, 4u, 8u})
        compare(of_few_motions(n),
                sticks,
                "on that of " + std::to_string(n) + " modes" + text);
    }
}
