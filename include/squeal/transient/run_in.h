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
   * Wear takes p |V| times a constant off the source face. The pressure stays
   * when the bodies follow without any change of force, by the motion that
   * nothing holds: along the normal, so that p |V| is the same at every node.
   * These forces with their friction fix the motion of the bodies, and the gap
   * is what closes it: g_0 = B_n u. How deep the wear is does not matter, as it
   * moves the bodies alone.
   *
   * @param areas    tributary areas of the nodes, m^2
   * @param friction mu >= 0 of every node
   * Throws InputError where no motion along the normal is free: wear would then
   * end with no pressure at all.
   */
  Eigen::VectorXd worn_gap(const ReducedContactModel &model,
                           const std::vector<double> &areas,
                           const Eigen::VectorXd     &friction);
} // namespace squeal

#endif
