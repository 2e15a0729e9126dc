// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_analyses_limit_cycle_cycle_columns_h
#define squeal_analyses_limit_cycle_cycle_columns_h

#include <squeal/cycle/cycle_branch.h>
#include <squeal/results/column_of.h>

#include <string>

namespace squeal
{
  /** What limit cycles have in common wherever they are listed. */
  struct CycleRow
  {
    const CycleFigures       &figures;
    const FloquetMultipliers &multipliers;
    double                    residual; /**< NaN: no iteration has begun */
    unsigned int              n_iterations;
    bool is_found; /**< else the cells of what is not there are empty */
  };

  CycleRow cycle_row(const CycleResult &cycle);
  CycleRow cycle_row(const BranchPoint &point);

  /** The common column @p name. */
  const ColumnOf<CycleRow> &common_cycle_column(const std::string &name);

  /** The same for rows of another kind. */
  template <typename Row>
  ColumnOf<Row>
  common(const std::string &name)
  {
    const ColumnOf<CycleRow> &column = common_cycle_column(name);
    return {column.declaration,
            [&column](const Row &row) { return column.value(cycle_row(row)); }};
  }
} // namespace squeal

#endif
