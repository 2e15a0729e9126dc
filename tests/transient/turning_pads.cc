// SPDX-License-Identifier: LGPL-2.1-or-later

// Two pads on two sides of a disc whose mesh turns under both: the pads, mirror
// images of each other, carry the same forces while nodes pass them, and those
// of a disc that stands still and slides; each loses as much, and the ledger
// closes.

#include "transient/two_pads.h"
#include "worst.h"

#include <deal.II/base/mpi.h>

#include <cstdio>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  using Frame = TransientParameters::DiscFrame;

  constexpr double mu = .1, speed = 20., end = 6e-4; // m/s, s

  Parameters
  brake(const Frame frame)
  {
    SceneParameters scene = disc_brake(mu);
    // Some nodes of the disc pass under the pads within a short time.
    scene.bodies[0].cells = {{40, 3, 1}};
    for (auto &contact : scene.contacts)
      contact.sliding_speed = speed;
    Parameters p                = parameters_of(scene);
    p.transient.integrator      = TransientParameters::Integrator::implicit;
    p.transient.disc_frame      = frame;
    p.transient.time_step       = 2e-6;
    p.transient.sample_interval = 2e-5;
    p.transient.end_time        = end;
    p.transient.tolerance       = 1e-10;
    p.transient.disturbance     = 0.;
    return p;
  }

  TransientRecord
  run(const Frame frame)
  {
    Pressed                 r(brake(frame));
    const PreparedTransient prepared(r.pressed, r.p, r.timers);
    TransientRun            motion(prepared.pressed,
                        prepared.steady,
                        prepared.linear,
                        prepared.branches,
                        r.p);
    check(motion.advance(), "runs to its end");
    return motion.record();
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const TransientRecord                    still = run(Frame::eulerian),
                        turns                    = run(Frame::corotating);
  const std::size_t n                            = turns.samples.size();
  check(n == still.samples.size() && n == 31, "as many samples");
  check(turns.n_pairs() == 2 && still.n_pairs() == 2, "two pads");
  Worst  mirror, ledger;
  double forces[2][2] = {}, before[2][2] = {}; // N, means
  for (std::size_t k = 0; k < n; ++k)
    {
      const PairSample &upper = turns.pair(k, 0), &lower = turns.pair(k, 1);
      mirror.add(std::abs(upper.normal / lower.normal - 1.));
      mirror.add(std::abs(upper.tangential / lower.tangential - 1.));
      mirror.add(k == 0 ? 0. : std::abs(upper.friction / lower.friction - 1.));
      ledger.add(turns.samples[k].imbalance);
      for (unsigned int i = 0; i < 2; ++i)
        {
          forces[i][0] += turns.pair(k, i).normal / n;
          forces[i][1] += turns.pair(k, i).tangential / n;
          before[i][0] += still.pair(k, i).normal / n;
          before[i][1] += still.pair(k, i).tangential / n;
        }
    }
  check_below(mirror.largest(), 1e-6, "mirrored pads carry and lose the same");
  check_below(ledger.largest(), 1e-3, "the ledger closes");
  for (unsigned int i = 0; i < 2; ++i)
    {
      const double loss       = turns.pair(n - 1, i).friction,
                   loss_still = still.pair(n - 1, i).friction;
      std::printf("pair %u: %.4f N, %.4f N along, loses %.5g J; beside still "
                  "%.4f N, %.4f N, %.5g J\n",
                  i,
                  forces[i][0],
                  forces[i][1],
                  loss,
                  before[i][0],
                  before[i][1],
                  loss_still);
      for (unsigned int c = 0; c < 2; ++c)
        check_below(std::abs(forces[i][c] / before[i][c] - 1.),
                    1e-3,
                    "forces are those of a disc that stands still and slides");
      check_below(
        std::abs(loss / loss_still - 1.), 1e-3, "and so is what is lost");
    }
}
