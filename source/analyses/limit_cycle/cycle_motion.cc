// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/analyses/limit_cycle/cycle_motion.h>

namespace squeal
{
  Block
  motion_of_cycle(const SteadyModel &about,
                  const Orbit       &orbit,
                  const unsigned int n_frames)
  {
    const ReducedContactModel &model = about.pressed.model();
    const FullContactModel     full  = about.pressed.full_model(about.sliding);
    Eigen::MatrixXd            q(model.n_modes(), n_frames),
      lambda(3 * model.n_nodes(), n_frames);
    for (unsigned int k = 0; k < n_frames; ++k)
      {
        const MotionState &state =
          orbit.states[(k * orbit.n_steps() + n_frames / 2) / n_frames];
        q.col(k)      = state.coordinates;
        lambda.col(k) = state.forces;
      }
    const Block contact = full.relative_motion->apply_transposed(lambda);
    return about.pressed.expand(
      static_motions(full, q, (-contact).colwise() + full.load));
  }
} // namespace squeal
