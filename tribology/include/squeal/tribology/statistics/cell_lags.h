// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_statistics_cell_lags_h
#define squeal_tribology_statistics_cell_lags_h

#include <Eigen/Core>

#include <array>
#include <vector>

namespace squeal::tribology
{
  /** Column and row of a cell on a lattice of even steps. */
  using CellColumnRow = std::array<std::size_t, 2>;

  /**
   * Pairs of cells of a grid by the lag between them, along both axes and with
   * its sign: what two maps have in common in any direction, as bands and waves
   * do. Several cells of a graded grid may stand at one place of the lattice:
   * pairs of them are a lag of their own.
   */
  class CellLags
  {
  public:
    explicit CellLags(const std::vector<CellColumnRow> &cells);

    /**
     * Variance of the correlation of two unrelated maps, 1 over the number of
     * independent cells: the sum over all lags of the product of both
     * autocorrelations and the pairs with that lag, over the square of the
     * cells (Clifford, Richardson and Hemon 1989, with lags for distances). A
     * value for each cell, with a mean of 0 or nearly.
     */
    double variance(const Eigen::VectorXd &x, const Eigen::VectorXd &y) const;

    /** What it is, to a good approximation, for maps that are white in a space
     * with the orthonormal columns @p basis: 1 over its dimension or less. */
    double variance_in(const Eigen::MatrixXd &basis) const;

    /** Largest sum over a row or a column of the lattice over that of all, and
     * below 0 where all of them have the other sign. */
    double largest_share_of_line(const Eigen::VectorXd &of_cells) const;

  private:
    /** Sums of the values at each place of the rectangle round all cells. */
    Eigen::MatrixXd on_rectangle(const Eigen::VectorXd &values) const;

    /** Sums over the pairs of each lag, half of the lags: first each cell with
     * itself, last different cells at one place. */
    Eigen::VectorXd sums(const Eigen::VectorXd &of_cells) const;

    double variance_of(const Eigen::VectorXd &a,
                       const Eigen::VectorXd &b) const;

    std::vector<CellColumnRow> cells;
    std::size_t                n_columns = 0, n_rows = 0;
    Eigen::VectorXd            counts;
  };
} // namespace squeal::tribology

#endif
