// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_output_open_scene_output_h
#define squeal_output_open_scene_output_h

#include <squeal/model/model.h>
#include <squeal/run/run_context.h>

#include <string>

namespace squeal
{
  /**
   * Writes a scene whose contact pairs are cut open as a scene of kind
   * `matrices` into @p folder of the output directory: the matrices of bodies,
   * springs and ties, nodes.csv with place, body and loads of every unknown
   * and its weight in the mean motion of the far faces,
   * contact.csv with the point pairs of the contacts, and scene.prm, which is
   * to be included. Steady sliding, eigenvalues about it and transients of it
   * are those of the scene. Throws InputError on several ranks and for held
   * supports, which matrices do not have.
   */
  void write_open_scene(RunContext        &context,
                        const Model       &model,
                        const std::string &folder);
} // namespace squeal

#endif
