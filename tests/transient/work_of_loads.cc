// SPDX-License-Identifier: LGPL-2.1-or-later

// The work of a load that comes on, and the elastic energy it leaves, are the
// same whether a mode moves or belongs to the residual flexibility.

#include "check.h"
#include "transient/hand_made.h"

#include <squeal/transient/reduced_transient.h>

#include <cmath>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  constexpr double time_step = 2e-5, end = .1;

  /** Three modes at one node, of which the last one is fast, and what the
   * contact gives way, under a load that bends the fast one most. */
  ReducedContactModel
  three_modes()
  {
    ReducedContactModel m = empty_model(1, 3);
    m.omega_squared << 4e5, 9e5, 1e8;
    m.damping = .2 * m.omega_squared.cwiseSqrt();
    m.participation << -1., .2, -.5, .1, 1., .3, .2, -.1, .4;
    m.flexibility.diagonal().setConstant(1e-8);
    m.load << -2., .3, -60.;
    m.cut_off = 1e4;
    return m;
  }

  /** The same with the last mode in the residual flexibility. */
  ReducedContactModel
  two_modes()
  {
    const ReducedContactModel whole         = three_modes();
    ReducedContactModel       m             = empty_model(1, 2);
    const Eigen::VectorXd     last          = whole.participation.col(2);
    const double              omega_squared = whole.omega_squared[2];
    m.omega_squared                         = whole.omega_squared.head(2);
    m.damping                               = whole.damping.head(2);
    m.participation                         = whole.participation.leftCols(2);
    m.load                                  = whole.load.head(2);
    m.flexibility = whole.flexibility + last * last.transpose() / omega_squared;
    m.load_motion = last * whole.load[2] / omega_squared;
    m.load_flexibility = std::pow(whole.load[2], 2) / omega_squared;
    m.cut_off          = 1e3;
    return m;
  }

  EnergyLedger
  pressed(const ReducedContactModel &m)
  {
    TransientDrive drive;
    drive.friction = [](double) { return .2; };
    drive.speed    = [](double) { return .1; };
    drive.load     = [](const double time) {
      return .5 - .5 * std::cos(M_PI * std::min(1., 2. * time / end));
    };
    drive.flexibility = Eigen::MatrixXd::Constant(1, 1, m.load_flexibility);
    ReducedTransient run(m, time_step, drive, 1., 1e-12);
    run.start(Eigen::VectorXd::Zero(m.n_modes()),
              Eigen::VectorXd::Zero(m.n_modes()),
              Eigen::VectorXd::Zero(3));
    while (run.time() < end)
      run.advance();
    check(run.ledger().imbalance() < 1e-4, "the ledger is balanced");
    return run.ledger();
  }

  void
  check_same(const double found, const double expected, const std::string &text)
  {
    check(std::abs(found - expected) < 5e-3 * std::abs(expected),
          text + ": " + std::to_string(1e6 * found) + " uJ, with all modes " +
            std::to_string(1e6 * expected) + " uJ");
  }
} // namespace



int
main()
{
  const EnergyLedger all = pressed(three_modes()), rest = pressed(two_modes());
  check_same(rest.load, all.load, "work of the load");
  check_same(rest.elastic, all.elastic, "elastic energy");
}
