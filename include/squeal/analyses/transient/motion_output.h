// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_analyses_transient_motion_output_h
#define squeal_analyses_transient_motion_output_h

#include <squeal/analyses/transient/transient_results.h>
#include <squeal/run/run_context.h>

namespace squeal
{
  /** The motion of all unknowns of the discretisation, one column for each of
   * the record's frames, m: that of a full model itself, or that of the modes
   * with the static residual deformation under loads and contact forces.
   * A held support counts from where it is held. */
  Block motion_of_frames(const PreparedTransient &prepared,
                         const TransientRecord   &record,
                         const Parameters        &parameters);

  /** Writes motion.pvd and contact.pvd of the record's frames, whose @p motion
   * is that of motion_of_frames(); returns the name of the first, "" where
   * there are no frames. Collective. */
  std::string write_animation(RunContext              &context,
                              const Model             &model,
                              const PreparedTransient &prepared,
                              const TransientRecord   &record,
                              const Block             &motion);
} // namespace squeal

#endif
