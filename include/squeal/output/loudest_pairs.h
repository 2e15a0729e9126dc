// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_output_loudest_pairs_h
#define squeal_output_loudest_pairs_h

#include <squeal/output/cea_quantities.h>
#include <squeal/results/table.h>

#include <vector>

namespace squeal
{
  /** Which pairs of a band an analysis of many models lists. */
  struct LoudestPairs
  {
    /** Numbers of all unstable pairs, the loudest last; of the loudest alone
     * where none is unstable. */
    std::vector<unsigned int> numbers;
    unsigned int              n_unstable = 0;
  };

  /** @throws ComputationError if the band holds no pair. */
  LoudestPairs loudest_pairs(const ComplexPairs &pairs);

  /** Appends the columns of a pair in such a list: frequency in Hz, growth rate
   * in 1/s, name, relative error of the reduction. */
  void append_pair_columns(std::vector<Table::Column> &columns);

  /** Appends the cells of these columns for pair @p i. */
  void append_pair_cells(std::vector<Cell>           &cells,
                         const ComplexPairs          &pairs,
                         const std::vector<ModeName> &names,
                         const unsigned int           i);
} // namespace squeal

#endif
