// SPDX-License-Identifier: LGPL-2.1-or-later

// A branch of periodic motions of a mass whose friction turns within the face:
// its cycles are not linear though no node opens or sticks, and it goes on to
// steady sliding.

#include "cycle/branches.h"
#include "worst.h"

#include <algorithm>
#include <cstdio>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  /** 1 kg on springs that couple its motion normal to the belt, along and
   * across it: its friction turns, so that its cycles grow from nothing. */
  ReducedContactModel
  moving_across()
  {
    ReducedContactModel m = empty_model(1, 4);
    Eigen::MatrixXd     K(3, 3); // along, normal, across
    K << 1.5, -.3, -.2, -.3, .5, 0., -.2, 0., .9;
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(K);
    m.omega_squared << modes.eigenvalues(), 2.;
    m.damping = Eigen::Vector4d::Constant(.05);
    for (unsigned int k = 0; k < 3; ++k)
      {
        m.participation(0, k) = -modes.eigenvectors()(1, k);
        m.participation(1, k) = -modes.eigenvectors()(0, k);
        m.participation(2, k) = -modes.eigenvectors()(2, k);
        m.load[k]             = -modes.eigenvectors()(1, k);
      }
    m.participation(2, 3) = -1e-3;
    m.flexibility         = Eigen::Vector3d(1., .05, .05).asDiagonal();
    return m;
  }


  /** No node opens or sticks on the lower part of the branch, which goes on to
   * steady sliding where the pair begins to grow. */
  void
  turning()
  {
    const ReducedContactModel m        = moving_across();
    const double              speed    = .3;
    const PeriodMaps          maps     = over_friction(m, speed);
    const double              critical = critical_friction(m, speed, .6),
                 start_at              = 1.1 * critical;
    Start start                        = start_of(m, maps, start_at, 256);
    start.settings.lower               = .5 * critical;
    start.settings.upper               = 1.3 * critical;
    start.settings.largest_step        = .2;
    const CycleBranch b =
      follow_branch(maps, start.motion, start_at, start.settings);
    print(b, "turning");
    std::printf("critical friction %.8f\n", critical);
    check(b.first_end == BranchEnd::onset && b.last_end == BranchEnd::range,
          "from the onset to the end of the range");
    const BranchPoint &least = b.points.front();
    check_close(
      least.parameter, critical, 1e-3, "the pair begins to grow there");
    check_below(figures_of(least.motion.orbit).rms,
                .1 * figures_of(start.motion.orbit).rms,
                "next to steady sliding");
    const auto n =
      std::count_if(b.points.begin(), b.points.end(), [](const BranchPoint &x) {
        return x.n_changes == 0 && x.friction_turn > onset_turn;
      });
    check(n > 5, "cycles without a change of status are no onset");
  }
} // namespace

int
main()
{
  turning();
}
