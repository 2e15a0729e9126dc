// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/sparse_matrix.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <numeric>

namespace squeal
{
  namespace
  {
    /** Rows that are multiplied together. */
    constexpr int tile_height = 6;

    template <int width>
    using RowBlock =
      Eigen::Matrix<double, Eigen::Dynamic, width, Eigen::RowMajor>;

    /** One entry with the rows and columns of both triangles. */
    template <bool absolute, int width>
    inline void
    multiply_entry(const double           value,
                   const int              i,
                   const int              j,
                   const double           sign,
                   const RowBlock<width> &X,
                   RowBlock<width>       &Y)
    {
      const double a = absolute ? std::abs(value) : value;
      Y.row(i) += a * X.row(j);
      if (j != i)
        Y.row(j) += (sign * a) * X.row(i);
    }

    /** The columns that @p height rows from @p first on share: their part of
     * X and Y stays in registers. */
    template <bool absolute, int height, int width>
    void
    multiply_tile(const int                       first,
                  const std::size_t               n_shared,
                  const std::vector<std::size_t> &row_starts,
                  const std::vector<int>         &columns,
                  const std::vector<double>      &values,
                  const double                    factor,
                  const double                    sign,
                  const RowBlock<width>          &X,
                  RowBlock<width>                &Y)
    {
      using Vector = Eigen::Matrix<double, 1, width>;
      Vector        x[height], sum[height];
      const double *a[height];
      for (int r = 0; r < height; ++r)
        {
          x[r]   = sign * X.row(first + r);
          sum[r] = Vector::Zero();
          a[r]   = values.data() + row_starts[first + r];
        }
      const int *column = columns.data() + row_starts[first];
      for (std::size_t k = 0; k < n_shared; ++k)
        {
          const Vector x_k = X.row(column[k]);
          Vector       y_k = Y.row(column[k]);
          for (int r = 0; r < height; ++r)
            {
              const double v =
                factor * (absolute ? std::abs(a[r][k]) : a[r][k]);
              sum[r] += v * x_k;
              y_k += v * x[r];
            }
          Y.row(column[k]) = y_k;
        }
      for (int r = 0; r < height; ++r)
        {
          Y.row(first + r) += sum[r];
          for (std::size_t k = row_starts[first + r] + n_shared;
               k < row_starts[first + r + 1];
               ++k)
            multiply_entry<absolute, width>(
              factor * values[k], first + r, columns[k], sign, X, Y);
        }
    }

    /** Y += factor A X for @p width vectors at once, from the lower triangle. One
     * pass over the matrix serves all of them: the product is bound by memory
     * traffic. */
    template <bool absolute, int width>
    void
    multiply_chunk(const std::vector<int>         &tiles,
                   const std::vector<std::size_t> &row_starts,
                   const std::vector<int>         &columns,
                   const std::vector<double>      &values,
                   const double                    factor,
                   const double                    sign,
                   const RowBlock<width>          &X,
                   RowBlock<width>                &Y)
    {
      for (std::size_t t = 0; t + 1 < tiles.size(); ++t)
        {
          const int         first = tiles[t];
          const std::size_t n_shared =
            std::lower_bound(columns.begin() + row_starts[first],
                             columns.begin() + row_starts[first + 1],
                             first) -
            (columns.begin() + row_starts[first]);
          if (row_starts[first] == row_starts[tiles[t + 1]])
            continue;
          const auto multiply = [&](auto height) {
            multiply_tile<absolute, decltype(height)::value, width>(
              first, n_shared, row_starts, columns, values, factor, sign, X, Y);
          };
          switch (tiles[t + 1] - first)
            {
            case 1:
              multiply(std::integral_constant<int, 1>());
              break;
            case 2:
              multiply(std::integral_constant<int, 2>());
              break;
            case 3:
              multiply(std::integral_constant<int, 3>());
              break;
            case 4:
              multiply(std::integral_constant<int, 4>());
              break;
            case 5:
              multiply(std::integral_constant<int, 5>());
              break;
            default:
              multiply(std::integral_constant<int, tile_height>());
            }
        }
    }

    /** First rows of runs of at most tile_height rows with the same columns
     * left of the run: the unknowns of one vertex, edge, face or cell. */
    std::vector<int>
    find_tiles(const std::vector<std::size_t> &row_starts,
               const std::vector<int>         &columns)
    {
      const int        n = static_cast<int>(row_starts.size()) - 1;
      std::vector<int> tiles;
      for (int i = 0; i < n;)
        {
          tiles.push_back(i);
          const int  first = i;
          const auto begin = columns.begin() + row_starts[first];
          const auto end   = std::lower_bound(
            begin, columns.begin() + row_starts[first + 1], first);
          const auto shared = end - begin;
          for (++i; i < n && i < first + tile_height; ++i)
            {
              const auto other = columns.begin() + row_starts[i],
                         stop  = columns.begin() + row_starts[i + 1];
              if (stop - other < shared || !std::equal(begin, end, other) ||
                  (stop - other > shared && other[shared] < first))
                break;
            }
        }
      tiles.push_back(n);
      return tiles;
    }
  } // namespace



  SparseMatrix::SparseMatrix(std::shared_ptr<const RowSpace> space,
                             std::vector<std::size_t>        starts,
                             std::vector<int>                cols,
                             std::vector<double>             vals,
                             const Symmetry                  symmetry)
    : row_space(std::move(space))
    , row_starts(std::move(starts))
    , columns(std::move(cols))
    , values(std::move(vals))
    , kind(symmetry)
  {
    AssertDimension(row_starts.size(), row_space->n_local() + 1);
    AssertDimension(columns.size(), values.size());
    tiles = find_tiles(row_starts, columns);
  }



  SparseMatrix::SparseMatrix(std::shared_ptr<const RowSpace> space,
                             const Triplets                 &lower,
                             const Symmetry                  symmetry)
    : row_space(std::move(space))
    , row_starts(row_space->n_local() + 1, 0)
    , kind(symmetry)
  {
    std::vector<std::size_t> order(lower.rows.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(),
                     order.end(),
                     [&](const std::size_t a, const std::size_t b) {
                       return std::make_pair(lower.rows[a], lower.columns[a]) <
                              std::make_pair(lower.rows[b], lower.columns[b]);
                     });
    std::vector<int> entry_rows;
    for (const std::size_t k : order)
      if (!entry_rows.empty() && entry_rows.back() == lower.rows[k] &&
          columns.back() == lower.columns[k])
        values.back() += lower.values[k];
      else
        {
          Assert(lower.columns[k] <= lower.rows[k], dealii::ExcInternalError());
          entry_rows.push_back(lower.rows[k]);
          columns.push_back(lower.columns[k]);
          values.push_back(lower.values[k]);
        }
    for (const int row : entry_rows)
      ++row_starts[row + 1];
    std::partial_sum(row_starts.begin(), row_starts.end(), row_starts.begin());
    tiles = find_tiles(row_starts, columns);
  }



  template <bool absolute, int width>
  void
  SparseMatrix::add_to_columns(const double           factor,
                               const RowBlock<width> &x,
                               RowBlock<width>       &y) const
  {
    const double sign = absolute || kind == Symmetry::symmetric ? 1. : -1.;
    multiply_chunk<absolute, width>(
      tiles, row_starts, columns, values, factor, sign, x, y);
  }

  template <bool absolute>
  Block
  SparseMatrix::sum_of_products(const std::vector<Term> &terms, const Block &X)
  {
    const RowSpace &space = *terms.at(0).second->row_space;
    if (!space.is_whole())
      return space.scatter_add(
        local_products<absolute>(terms, space.gather(X)));
    return local_products<absolute>(terms, X);
  }

  template <bool absolute>
  Eigen::MatrixXd
  SparseMatrix::local_products(const std::vector<Term> &terms,
                               const Eigen::MatrixXd   &X)
  {
    Eigen::MatrixXd result(X.rows(), X.cols());
    int             first    = 0;
    const auto      multiply = [&](const auto width_constant) {
      constexpr int   width = decltype(width_constant)::value;
      const int       n     = std::min<int>(width, X.cols() - first);
      RowBlock<width> x(X.rows(), width);
      if (n < width)
        x.rightCols(width - n).setZero();
      x.leftCols(n)     = X.middleCols(first, n);
      RowBlock<width> y = RowBlock<width>::Zero(X.rows(), width);
      for (const auto &[factor, matrix] : terms)
        matrix->template add_to_columns<absolute, width>(factor, x, y);
      result.middleCols(first, n) = y.leftCols(n);
      first += width;
    };
    while (X.cols() - first > 8)
      multiply(std::integral_constant<int, 16>());
    while (X.cols() - first > 2)
      multiply(std::integral_constant<int, 8>());
    while (first < X.cols())
      multiply(std::integral_constant<int, 2>());
    return result;
  }



  Block
  SparseMatrix::multiply(const Block &X) const
  {
    return sum_of_products<false>({{1., this}}, X);
  }

  Block
  SparseMatrix::multiply_sum(const std::vector<Term> &terms, const Block &X)
  {
    return sum_of_products<false>(terms, X);
  }

  Block
  SparseMatrix::multiply_absolute(const Block &X) const
  {
    return sum_of_products<true>({{1., this}}, X.cwiseAbs());
  }

  Block
  SparseMatrix::multiply_transposed(const Block &X) const
  {
    return kind == Symmetry::symmetric
             ? multiply(X)
             : sum_of_products<false>({{-1., this}}, X);
  }

  bool
  SparseMatrix::is_symmetric() const
  {
    return kind == Symmetry::symmetric;
  }



  void
  SparseMatrix::append_to(Triplets    &triplets,
                          const double factor,
                          const bool   lower_only) const
  {
    const std::size_t old_size = triplets.rows.size();
    triplets.rows.resize(old_size + columns.size());
    triplets.columns.resize(old_size + columns.size());
    triplets.values.resize(old_size + columns.size());
    std::size_t  out  = old_size;
    const double sign = kind == Symmetry::symmetric ? 1. : -1.;
    for (std::size_t i = 0; i + 1 < row_starts.size(); ++i)
      {
        const int row = static_cast<int>(row_space->global(i));
        for (std::size_t k = row_starts[i]; k < row_starts[i + 1]; ++k, ++out)
          {
            const int column = static_cast<int>(row_space->global(columns[k]));
            // Ghost rows are numbered after the owned ones: an entry of the
            // local lower triangle may lie in the global upper one.
            triplets.rows[out]    = std::max(row, column);
            triplets.columns[out] = std::min(row, column);
            triplets.values[out] =
              factor * (row >= column ? 1. : sign) * values[k];
          }
      }
    if (!lower_only)
      for (std::size_t k = old_size; k < out; ++k)
        if (triplets.rows[k] != triplets.columns[k])
          triplets.add(
            triplets.columns[k], triplets.rows[k], sign * triplets.values[k]);
  }



  void
  SparseMatrix::append_rows_to(Triplets                &triplets,
                               const std::vector<bool> &wanted) const
  {
    const double sign = kind == Symmetry::symmetric ? 1. : -1.;
    for (std::size_t i = 0; i + 1 < row_starts.size(); ++i)
      {
        const int row = static_cast<int>(row_space->global(i));
        for (std::size_t k = row_starts[i]; k < row_starts[i + 1]; ++k)
          {
            const int column = static_cast<int>(row_space->global(columns[k]));
            if (wanted[row])
              triplets.add(row, column, values[k]);
            if (wanted[column] && column != row)
              triplets.add(column, row, sign * values[k]);
          }
      }
  }



  void
  SparseMatrix::add(const double factor, const SparseMatrix &other)
  {
    Assert(same_pattern(other), dealii::ExcInternalError());
    for (std::size_t k = 0; k < values.size(); ++k)
      values[k] += factor * other.values[k];
  }

  bool
  SparseMatrix::same_pattern(const SparseMatrix &other) const
  {
    return row_starts == other.row_starts && columns == other.columns &&
           kind == other.kind;
  }

  SparseMatrix::Symmetry
  SparseMatrix::symmetry() const
  {
    return kind;
  }

  std::size_t
  SparseMatrix::n_nonzeros() const
  {
    return values.size();
  }

  const RowSpace &
  SparseMatrix::space() const
  {
    return *row_space;
  }
} // namespace squeal
