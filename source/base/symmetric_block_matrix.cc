// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/symmetric_block_matrix.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace squeal
{
  namespace
  {
    /** Rows and columns of the lower triangle with their values, sorted. */
    struct SortedRows
    {
      SortedRows(const Triplets &lower, const Eigen::Index n)
        : starts(n + 1, 0)
      {
        std::vector<std::size_t> order(lower.rows.size());
        std::iota(order.begin(), order.end(), 0);
        std::stable_sort(
          order.begin(),
          order.end(),
          [&](const std::size_t a, const std::size_t b) {
            return std::make_pair(lower.rows[a], lower.columns[a]) <
                   std::make_pair(lower.rows[b], lower.columns[b]);
          });
        for (const std::size_t k : order)
          {
            columns.push_back(lower.columns[k]);
            values.push_back(lower.values[k]);
            ++starts[lower.rows[k] + 1];
          }
        std::partial_sum(starts.begin(), starts.end(), starts.begin());
      }

      /** Whether row @p i has the columns of row @p first left of it, and row
       * @p first itself: unknowns of one vertex. */
      bool
      belongs_to(const int first, const int i) const
      {
        const auto begin = columns.begin() + starts[first],
                   end   = std::lower_bound(
                     begin, columns.begin() + starts[first + 1], first),
                   other = columns.begin() + starts[i],
                   stop  = columns.begin() + starts[i + 1];
        return stop - other > end - begin && std::equal(begin, end, other) &&
               other[end - begin] == first;
      }

      std::vector<std::size_t> starts;
      std::vector<int>         columns;
      std::vector<double>      values;
    };
  } // namespace



  SymmetricBlockMatrix::SymmetricBlockMatrix(const Triplets    &lower,
                                             const Eigen::Index size)
    : n(size)
  {
    const SortedRows rows(lower, n);
    std::vector<int> group(n), place(n);
    for (int i = 0; i < n; ++i)
      {
        if (i == 0 || i - group_starts.back() == width ||
            !rows.belongs_to(group_starts.back(), i))
          group_starts.push_back(i);
        group[i] = static_cast<int>(group_starts.size()) - 1;
        place[i] = i - group_starts.back();
      }
    const int n_groups = static_cast<int>(group_starts.size());
    group_starts.push_back(static_cast<int>(n));
    row_starts.assign(n_groups + 1, 0);
    diagonal.assign(width * width * n_groups + 1, 0.);

    for (int g = 0; g < n_groups; ++g)
      {
        const std::size_t first = row_starts[g];
        for (std::size_t k = rows.starts[group_starts[g]];
             k < rows.starts[group_starts[g + 1]];
             ++k)
          if (group[rows.columns[k]] != g)
            columns.push_back(group[rows.columns[k]]);
        std::sort(columns.begin() + first, columns.end());
        columns.erase(std::unique(columns.begin() + first, columns.end()),
                      columns.end());
        row_starts[g + 1] = columns.size();
        values.resize(width * width * columns.size(), 0.);
        for (int i = group_starts[g]; i < group_starts[g + 1]; ++i)
          for (std::size_t k = rows.starts[i]; k < rows.starts[i + 1]; ++k)
            {
              const int j = rows.columns[k];
              if (group[j] == g)
                {
                  double *block = &diagonal[width * width * g];
                  block[width * place[i] + place[j]] += rows.values[k];
                  if (i != j)
                    block[width * place[j] + place[i]] += rows.values[k];
                }
              else
                values[width * width *
                         (std::lower_bound(
                            columns.begin() + first, columns.end(), group[j]) -
                          columns.begin()) +
                       width * place[i] + place[j]] += rows.values[k];
            }
      }
    // A row of a block is read as four values: one more behind the last.
    values.push_back(0.);
    x_padded.assign(padded * n_groups, 0.);
    y_padded.assign(padded * n_groups, 0.);
  }



  void
  SymmetricBlockMatrix::multiply(const Eigen::VectorXd &x, Eigen::VectorXd &y)
  {
    using Four  = Eigen::Array<double, padded, 1>;
    using Group = Eigen::Map<Four>;
    using Row   = Eigen::Map<const Four>;
    // The fourth place of x stays zero, that of y collects what nobody reads.
    const int n_groups = static_cast<int>(group_starts.size()) - 1;
    for (int g = 0; g < n_groups; ++g)
      std::copy(x.data() + group_starts[g],
                x.data() + group_starts[g + 1],
                x_padded.data() + padded * g);
    std::fill(y_padded.begin(), y_padded.end(), 0.);

    for (int g = 0; g < n_groups; ++g)
      {
        const double *d   = diagonal.data() + width * width * g;
        const Four    x_g = Row(x_padded.data() + padded * g);
        Four sum[width]   = {Row(d) * x_g, Row(d + 3) * x_g, Row(d + 6) * x_g};
        const Four    each[width] = {Four::Constant(x_g[0]),
                                     Four::Constant(x_g[1]),
                                     Four::Constant(x_g[2])};
        const double *a = values.data() + width * width * row_starts[g];
        for (std::size_t k = row_starts[g]; k < row_starts[g + 1];
             ++k, a += width * width)
          {
            const Four row[width] = {Row(a), Row(a + 3), Row(a + 6)};
            const Row  x_k(x_padded.data() + padded * columns[k]);
            Group      y_k(y_padded.data() + padded * columns[k]);
            sum[0] += row[0] * x_k;
            sum[1] += row[1] * x_k;
            sum[2] += row[2] * x_k;
            y_k += row[0] * each[0] + row[1] * each[1] + row[2] * each[2];
          }
        double *y_g = y_padded.data() + padded * g;
        for (int r = 0; r < width; ++r)
          y_g[r] += sum[r][0] + sum[r][1] + sum[r][2];
      }
    y.resize(n);
    for (int g = 0; g < n_groups; ++g)
      std::copy(y_padded.data() + padded * g,
                y_padded.data() + padded * g + group_starts[g + 1] -
                  group_starts[g],
                y.data() + group_starts[g]);
  }



  Eigen::Index
  SymmetricBlockMatrix::n_rows() const
  {
    return n;
  }

  std::size_t
  SymmetricBlockMatrix::n_bytes() const
  {
    return (values.size() + diagonal.size()) * sizeof(double) +
           columns.size() * sizeof(int);
  }
} // namespace squeal
