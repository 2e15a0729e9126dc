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
              const double v = absolute ? std::abs(a[r][k]) : a[r][k];
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
              values[k], first + r, columns[k], sign, X, Y);
        }
    }

    /** Y += A X for @p width vectors at once, from the lower triangle. One
     * pass over the matrix serves all of them: the product is bound by memory
     * traffic. */
    template <bool absolute, int width>
    void
    multiply_chunk(const std::vector<int>         &tiles,
                   const std::vector<std::size_t> &row_starts,
                   const std::vector<int>         &columns,
                   const std::vector<double>      &values,
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
          const auto multiply = [&](auto height) {
            multiply_tile<absolute, decltype(height)::value, width>(
              first, n_shared, row_starts, columns, values, sign, X, Y);
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
  SparseMatrix::product_of_columns(const Eigen::MatrixXd &X,
                                   const int              first,
                                   Eigen::MatrixXd       &result) const
  {
    const double    sign = absolute || kind == Symmetry::symmetric ? 1. : -1.;
    const int       n    = std::min<int>(width, X.cols() - first);
    RowBlock<width> x(X.rows(), width);
    if (n < width)
      x.rightCols(width - n).setZero();
    x.leftCols(n)     = X.middleCols(first, n);
    RowBlock<width> y = RowBlock<width>::Zero(X.rows(), width);
    multiply_chunk<absolute, width>(
      tiles, row_starts, columns, values, sign, x, y);
    result.middleCols(first, n) = y.leftCols(n);
  }

  template <bool absolute>
  Block
  SparseMatrix::product(const Block &X) const
  {
    const Eigen::MatrixXd local = row_space->gather(X);
    Eigen::MatrixXd       result(local.rows(), local.cols());
    int                   first = 0;
    for (; local.cols() - first > 8; first += 16)
      product_of_columns<absolute, 16>(local, first, result);
    for (; local.cols() - first > 2; first += 8)
      product_of_columns<absolute, 8>(local, first, result);
    for (; first < local.cols(); first += 2)
      product_of_columns<absolute, 2>(local, first, result);
    return row_space->scatter_add(result);
  }



  Block
  SparseMatrix::multiply(const Block &X) const
  {
    return product<false>(X);
  }

  Block
  SparseMatrix::multiply_absolute(const Block &X) const
  {
    return product<true>(X.cwiseAbs());
  }

  Block
  SparseMatrix::multiply_transposed(const Block &X) const
  {
    return kind == Symmetry::symmetric ? multiply(X) : Block(-multiply(X));
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



  Functionals::Functionals(std::shared_ptr<const RowSpace> space,
                           std::vector<Row>                rows)
    : row_space(std::move(space))
    , all_rows(std::move(rows))
    , owned(all_rows.size(), row_space->n_owned())
  {
    const unsigned int                  first = row_space->first_owned();
    const unsigned int                  end   = first + row_space->n_owned();
    std::vector<Eigen::Triplet<double>> entries;
    for (unsigned int r = 0; r < all_rows.size(); ++r)
      for (const auto &[column, value] : all_rows[r])
        if (column >= first && column < end)
          entries.emplace_back(r, column - first, value);
    owned.setFromTriplets(entries.begin(), entries.end());
  }

  unsigned int
  Functionals::n_rows() const
  {
    return all_rows.size();
  }

  Eigen::MatrixXd
  Functionals::apply(const Block &X) const
  {
    Eigen::MatrixXd result = owned * X;
    row_space->sum(result);
    return result;
  }

  Eigen::MatrixXcd
  Functionals::apply(const ComplexBlock &X) const
  {
    Eigen::MatrixXcd result(n_rows(), X.cols());
    result.real() = apply(Block(X.real()));
    result.imag() = apply(Block(X.imag()));
    return result;
  }

  Eigen::MatrixXd
  Functionals::apply_absolute(const Block &X) const
  {
    Eigen::MatrixXd result = owned.cwiseAbs() * X.cwiseAbs();
    row_space->sum(result);
    return result;
  }

  Block
  Functionals::apply_transposed_absolute(const Eigen::MatrixXd &G) const
  {
    return owned.cwiseAbs().transpose() * G.cwiseAbs();
  }

  Block
  Functionals::apply_transposed(const Eigen::MatrixXd &G) const
  {
    return owned.transpose() * G;
  }

  ComplexBlock
  Functionals::apply_transposed(const Eigen::MatrixXcd &G) const
  {
    ComplexBlock result(row_space->n_owned(), G.cols());
    result.real() = owned.transpose() * G.real();
    result.imag() = owned.transpose() * G.imag();
    return result;
  }

  const RowSpace &
  Functionals::space() const
  {
    return *row_space;
  }

  const std::vector<Functionals::Row> &
  Functionals::rows() const
  {
    return all_rows;
  }



  Block
  LowRankOperator::multiply(const Block &X) const
  {
    return left_rows().apply_transposed(forces(X));
  }

  Block
  LowRankOperator::multiply_transposed(const Block &X) const
  {
    return transposed_forces(left_rows().apply(X));
  }



  LowRankMatrix::LowRankMatrix(std::shared_ptr<const Functionals> left_rows,
                               Eigen::VectorXd                    w,
                               std::shared_ptr<const Functionals> right_rows)
    : left(std::move(left_rows))
    , right(std::move(right_rows))
    , weights(std::move(w))
  {
    AssertDimension(left->n_rows(), right->n_rows());
    AssertDimension(left->n_rows(), weights.size());
    on_root = left->space().rank() == 0;
  }

  const Functionals &
  LowRankMatrix::left_rows() const
  {
    return *left;
  }

  Eigen::MatrixXd
  LowRankMatrix::forces(const Block &X) const
  {
    return weights.asDiagonal() * right->apply(X);
  }

  Block
  LowRankMatrix::transposed_forces(const Eigen::MatrixXd &g) const
  {
    return right->apply_transposed(Eigen::MatrixXd(weights.asDiagonal() * g));
  }

  Block
  LowRankMatrix::multiply_absolute(const Block &X) const
  {
    return left->apply_transposed_absolute(
      Eigen::MatrixXd(weights.asDiagonal() * right->apply_absolute(X)));
  }

  bool
  LowRankMatrix::is_symmetric() const
  {
    return left == right;
  }

  void
  LowRankMatrix::append_to(Triplets    &triplets,
                           const double factor,
                           const bool   lower_only) const
  {
    if (!on_root)
      return;
    for (unsigned int r = 0; r < left->n_rows(); ++r)
      for (const auto &[i, a] : left->rows()[r])
        for (const auto &[j, b] : right->rows()[r])
          if (!lower_only || i >= j)
            triplets.add(i, j, factor * weights[r] * a * b);
  }



  SumOperator::SumOperator(std::vector<Part> p)
    : parts(std::move(p))
  {
    Assert(!parts.empty(), dealii::ExcInternalError());
  }

  const std::vector<SumOperator::Part> &
  SumOperator::summands() const
  {
    return parts;
  }

  Block
  SumOperator::multiply(const Block &X) const
  {
    Block result = parts[0].first * parts[0].second->multiply(X);
    for (std::size_t i = 1; i < parts.size(); ++i)
      result += parts[i].first * parts[i].second->multiply(X);
    return result;
  }

  Block
  SumOperator::multiply_transposed(const Block &X) const
  {
    Block result = parts[0].first * parts[0].second->multiply_transposed(X);
    for (std::size_t i = 1; i < parts.size(); ++i)
      result += parts[i].first * parts[i].second->multiply_transposed(X);
    return result;
  }

  Block
  SumOperator::multiply_absolute(const Block &X) const
  {
    Block result =
      std::abs(parts[0].first) * parts[0].second->multiply_absolute(X);
    for (std::size_t i = 1; i < parts.size(); ++i)
      result +=
        std::abs(parts[i].first) * parts[i].second->multiply_absolute(X);
    return result;
  }

  bool
  SumOperator::is_symmetric() const
  {
    return std::all_of(parts.begin(), parts.end(), [](const Part &part) {
      return part.second->is_symmetric();
    });
  }

  void
  SumOperator::append_to(Triplets    &triplets,
                         const double factor,
                         const bool   lower_only) const
  {
    for (const auto &[weight, part] : parts)
      part->append_to(triplets, factor * weight, lower_only);
  }
} // namespace squeal
