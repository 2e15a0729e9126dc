// SPDX-License-Identifier: LGPL-2.1-or-later

// Rows over the ranks: ghost values are those of their owners, what ranks add
// to ghost rows reaches the owner, and all goes to the first rank and back.

#include "worst.h"

#include <squeal/base/row_space.h>

#include <deal.II/base/index_set.h>
#include <deal.II/base/mpi.h>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  constexpr unsigned int n = 11;

  unsigned int
  rank()
  {
    return dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
  }

  unsigned int
  n_ranks()
  {
    return dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
  }

  /** First row of rank @p r: unequal shares. */
  unsigned int
  first(const unsigned int r)
  {
    return r == 0 ? 0 : r == n_ranks() ? n : 4 + r;
  }

  /** Rank @p r touches its own rows, two on each side of them, and row 0. */
  bool
  touches(const unsigned int r, const unsigned int row)
  {
    return row == 0 || (row + 2 >= first(r) && row < first(r + 1) + 2);
  }

  RowSpace
  some_space()
  {
    dealii::IndexSet owned(n), relevant(n);
    owned.add_range(first(rank()), first(rank() + 1));
    for (unsigned int row = 0; row < n; ++row)
      if (touches(rank(), row))
        relevant.add_index(row);
    return RowSpace(owned, relevant, MPI_COMM_WORLD);
  }

  double
  value(const unsigned int row, const unsigned int column)
  {
    return std::sin(1. + row + 10. * column);
  }

  Block
  owned_values(const RowSpace &space, const unsigned int n_columns)
  {
    Block result(space.n_owned(), n_columns);
    for (unsigned int i = 0; i < space.n_owned(); ++i)
      for (unsigned int j = 0; j < n_columns; ++j)
        result(i, j) = value(space.first_owned() + i, j);
    return result;
  }

  void
  test_gather_and_scatter(const unsigned int n_columns)
  {
    const RowSpace        space = some_space();
    const Block           X     = owned_values(space, n_columns);
    const Eigen::MatrixXd all   = space.gather(X);
    check(all.rows() == space.n_local() && all.cols() == n_columns,
          "a row for every local one");
    Eigen::MatrixXd mine(space.n_local(), n_columns);
    for (unsigned int i = 0; i < space.n_local(); ++i)
      for (unsigned int j = 0; j < n_columns; ++j)
        {
          const unsigned int row = space.global(i);
          check(space.local(row) == i, "local of global");
          check(all(i, j) == value(row, j), "ghosts have their owner's value");
          mine(i, j) = value(row, j) * (1. + rank());
        }
    const Block sum = space.scatter_add(mine);
    check(sum.rows() == space.n_owned() && sum.cols() == n_columns,
          "a row for every owned one");
    Worst error;
    error.add(0.);
    for (unsigned int i = 0; i < sum.rows(); ++i)
      for (unsigned int j = 0; j < n_columns; ++j)
        {
          const unsigned int row      = space.first_owned() + i;
          double             expected = 0.;
          for (unsigned int r = 0; r < n_ranks(); ++r)
            if (touches(r, row))
              expected += value(row, j) * (1. + r);
          error.add(std::abs(sum(i, j) - expected));
        }
    check_within(error, 1e-14, "what all ranks add reaches the owner");
    // Both are each other's transposed.
    double parts[2] = {mine.cwiseProduct(all).sum(), sum.cwiseProduct(X).sum()};
    MPI_Allreduce(MPI_IN_PLACE, parts, 2, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
    check(std::abs(parts[0] - parts[1]) <= 1e-13, "transposed of each other");
  }

  void
  test_sums_and_root()
  {
    const RowSpace  space = some_space();
    const Block     X     = owned_values(space, 3);
    Eigen::MatrixXd whole(n, 3);
    for (unsigned int row = 0; row < n; ++row)
      for (unsigned int j = 0; j < 3; ++j)
        whole(row, j) = value(row, j);
    check(largest_abs(space.dot(X, X) - whole.transpose() * whole) <= 1e-13,
          "inner products");
    check(largest_abs(space.norms(X) - whole.colwise().norm().transpose()) <=
            1e-14,
          "norms");
    const Eigen::MatrixXd root = space.to_root(X);
    check(rank() == 0 ? root == whole : root.size() == 0, "all rows on rank 0");
    check(space.from_root(root, 3) == X, "and back");
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize init(argc, argv, 1);
  for (const unsigned int n_columns : {0, 1, 4})
    test_gather_and_scatter(n_columns);
  test_sums_and_root();
  const RowSpace alone(1);
  check(alone.is_whole() && alone.n_global() == 1 &&
          alone.scatter_add(Eigen::MatrixXd::Ones(1, 2)).sum() == 2.,
        "one row");
}
