// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patterned_matrix.h"

#include <algorithm>

namespace squeal
{
  CellRows
  cell_rows(const Discretization               &d,
            const Discretization::CellIterator &cell,
            const ElementMatrices              &element)
  {
    const unsigned int n = cell->get_fe().n_dofs_per_cell();
    std::vector<dealii::types::global_dof_index> dofs(n);
    cell->get_dof_indices(dofs);

    CellRows                         result;
    std::vector<std::array<int, 2>>  found; // row, dof
    std::vector<const Combination *> parts(n);
    const RowSpace                  &space = *d.space();
    for (unsigned int i = 0; i < n; ++i)
      {
        parts[i] = &d.expansion(dofs[i]);
        if (parts[i]->size() > 1 ||
            (parts[i]->size() == 1 && (*parts[i])[0].second != 1.))
          result.simple = false;
        for (const auto &[row, weight] : *parts[i])
          found.push_back(
            {{static_cast<int>(space.local(row)), static_cast<int>(i)}});
      }
    std::sort(found.begin(), found.end());
    for (const auto &[row, dof] : found)
      {
        const int c = static_cast<int>(element.component(dof));
        if (!result.rows.empty() && result.rows.back() == row)
          {
            result.simple = false;
            if (result.component.back() != c)
              result.component.back() = -1;
            continue;
          }
        result.rows.push_back(row);
        result.source.push_back(dof);
        result.component.push_back(c);
      }
    if (!result.simple)
      {
        result.T.setZero(n, result.rows.size());
        for (unsigned int i = 0; i < n; ++i)
          for (const auto &[row, weight] : *parts[i])
            {
              const auto it =
                std::lower_bound(result.rows.begin(),
                                 result.rows.end(),
                                 static_cast<int>(space.local(row)));
              result.T(i, it - result.rows.begin()) += weight;
            }
      }
    return result;
  }



  PatternedMatrix::PatternedMatrix(const std::shared_ptr<const RowSpace> &space,
                                   const std::vector<CellRows>           &cells,
                                   const bool same_component_only)
    : row_space(space)
    , same_component(same_component_only)
  {
    const unsigned int                     n = space->n_local();
    std::vector<std::vector<unsigned int>> cells_of_row(n);
    for (unsigned int c = 0; c < cells.size(); ++c)
      for (const int row : cells[c].rows)
        cells_of_row[row].push_back(c);
    std::vector<int> mark(n, -1);
    starts.assign(n + 1, 0);
    for (unsigned int row = 0; row < n; ++row)
      {
        for (const unsigned int c : cells_of_row[row])
          {
            const auto &rows = cells[c].rows;
            const auto  end =
              std::upper_bound(rows.begin(), rows.end(), int(row));
            const int component = cells[c].component[end - rows.begin() - 1];
            for (auto it = rows.begin(); it != end; ++it)
              if (mark[*it] != int(row) &&
                  couple(component, cells[c].component[it - rows.begin()]))
                {
                  mark[*it] = row;
                  columns.push_back(*it);
                }
          }
        std::sort(columns.begin() + starts[row], columns.end());
        starts[row + 1] = columns.size();
      }
    values.assign(columns.size(), 0.);
  }

  void
  PatternedMatrix::add(const CellRows &cell, const Eigen::MatrixXd &element)
  {
    const Eigen::MatrixXd expanded =
      cell.simple ? Eigen::MatrixXd()
                  : Eigen::MatrixXd(cell.T.transpose() * element * cell.T);
    for (unsigned int a = 0; a < cell.rows.size(); ++a)
      {
        std::size_t k = starts[cell.rows[a]];
        for (unsigned int b = 0; b <= a; ++b)
          {
            if (!couple(cell.component[a], cell.component[b]))
              continue;
            while (columns[k] < cell.rows[b])
              ++k;
            values[k] += cell.simple ? element(cell.source[b], cell.source[a]) *
                                         transpose_sign
                                     : expanded(b, a) * transpose_sign;
          }
      }
  }

  std::shared_ptr<const SparseMatrix>
  PatternedMatrix::finish()
  {
    return std::make_shared<const SparseMatrix>(
      row_space,
      std::move(starts),
      std::move(columns),
      std::move(values),
      transpose_sign > 0 ? SparseMatrix::Symmetry::symmetric
                         : SparseMatrix::Symmetry::skew);
  }

  bool
  PatternedMatrix::couple(const int a, const int b) const
  {
    return !same_component || a == b || a < 0 || b < 0;
  }
} // namespace squeal
