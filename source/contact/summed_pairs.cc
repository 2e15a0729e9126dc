// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/contact/contact_resultant.h>
#include <squeal/contact/summed_pairs.h>

namespace squeal
{
  bool
  is_summed(const ContactNodes &nodes, const ContactPair &pair)
  {
    return pair.slides() || nodes.speed() == 0.;
  }

  std::vector<double>
  transverse_senses(const ContactNodes &nodes)
  {
    std::vector<double>    senses;
    const ContactGeometry *first = nullptr;
    for (const ContactPair &pair : nodes.pairs())
      if (!is_summed(nodes, pair))
        senses.push_back(0.);
      else
        {
          if (!first)
            first = &pair.geometry;
          senses.push_back(transverse_sense(*first, pair.geometry));
        }
    return senses;
  }
} // namespace squeal
