// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_results_column_of_h
#define squeal_results_column_of_h

#include <squeal/results/table.h>

#include <functional>
#include <vector>

namespace squeal
{
  /** A column and what stands in it. */
  template <typename Row>
  struct ColumnOf
  {
    Table::Column                    declaration;
    std::function<Cell(const Row &)> value;
  };

  /** One row for each of @p rows. */
  template <typename Row>
  Table
  table_of(const std::vector<ColumnOf<Row>> &columns,
           const std::vector<Row>           &rows)
  {
    Table table;
    for (const ColumnOf<Row> &column : columns)
      table.add_column(column.declaration);
    for (const Row &row : rows)
      {
        std::vector<Cell> cells;
        for (const ColumnOf<Row> &column : columns)
          cells.push_back(column.value(row));
        table.add_row(cells);
      }
    return table;
  }
} // namespace squeal

#endif
