// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_transient_run_in_h
#define squeal_transient_run_in_h

#include <squeal/transient/reduced_contact_model.h>

#include <vector>

namespace squeal
{
  /**
   * The gap g_0 of the nodes, m, that Archard's wear leaves when it no longer
   * changes the pressure.
   *
   * Wear takes p |V| times a constant off the source faces. The pressure stays
   * when the bodies follow without any change of force, by motions that nothing
   * holds: so p |V| of every node is what such a motion, w, moves it along its
   * normal. For a body that is free along the normal alone p |V| is the same at
   * all of its nodes; each of several pads has its own. Balance with the loads
   * fixes w, the forces with their friction fix the motion of the bodies, and
   * the gap is what closes it: g_0 = B_n u. How deep the wear is does not
   * matter, as it moves the bodies alone.
   *
   * @param areas    tributary areas of the nodes, m^2
   * @param friction mu >= 0 of every node
   * Throws InputError where no motion along the normal is free: wear would then
   * end with no pressure at all; and where a pair is at rest, whose nodes do
   * not wear.
   */
  Eigen::VectorXd worn_gap(const ReducedContactModel &model,
                           const std::vector<double> &areas,
                           const Eigen::VectorXd     &friction);
} // namespace squeal

#endif
