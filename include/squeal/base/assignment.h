// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_base_assignment_h
#define squeal_base_assignment_h

#include <vector>

namespace squeal
{
  /**
   * The pairing of rows with columns of @p costs (all rows of the same length,
   * finite values) that has the smallest sum: each row has at most one column
   * and the other way round, and as many pairs as the shorter side allows are
   * made. Returns the column of each row, or -1. Kuhn's Hungarian method in the
   * form with potentials and shortest augmenting paths, n^3 operations.
   */
  std::vector<int> smallest_assignment(
    const std::vector<std::vector<double>> &costs);
} // namespace squeal

#endif
