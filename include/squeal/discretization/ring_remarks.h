// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_discretization_ring_remarks_h
#define squeal_discretization_ring_remarks_h

#include <squeal/discretization/discretization.h>

#include <string>
#include <vector>

namespace squeal
{
  /** One line for each face of a body without a ring, see disc_rings(), that
   * covers nearly so much of one, from 80 % of its area on. Collective. */
  std::vector<std::string> remarks_on_rings(
    const Discretization &discretization);
} // namespace squeal

#endif
