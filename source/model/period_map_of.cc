// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/model/period_map_of.h>

namespace squeal
{
  namespace
  {
    /** Of the largest force of a node that a step may miss the law by. */
    constexpr double contact_tolerance = 1e-10;
  } // namespace



  PeriodMap
  period_map_of(const SteadyModel &about)
  {
    const PressedModel          &pressed = about.pressed;
    std::vector<unsigned int>    nodes_of_pairs;
    std::vector<PressureMoments> moments;
    for (const ContactPair &pair : pressed.nodes().pairs())
      {
        nodes_of_pairs.push_back(pair.n_nodes());
        moments.push_back(pressure_moments(pair.geometry));
      }
    return {pressed.model(),
            CycleFriction::of_laws(pressed.nodes().laws(),
                                   pressed.model().n_nodes(),
                                   pressed.speed()),
            about.sliding.resultant()[0] / pressed.model().n_nodes(),
            contact_tolerance,
            nodes_of_pairs,
            moments};
  }
} // namespace squeal
