// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_contact_summed_pairs_h
#define squeal_contact_summed_pairs_h

#include <squeal/contact/contact_nodes.h>

#include <vector>

namespace squeal
{
  /** Whether @p pair counts for the resultants of a scene: pairs at rest do
   * only where none slides. */
  bool is_summed(const ContactNodes &nodes, const ContactPair &pair);

  /** For each pair 1 or -1, with which forces across its sliding add up to one
   * of the scene: as transverse_sense() against the first pair that is summed.
   * 0 for pairs that are not. */
  std::vector<double> transverse_senses(const ContactNodes &nodes);
} // namespace squeal

#endif
