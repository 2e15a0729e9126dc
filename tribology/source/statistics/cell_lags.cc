// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/tribology/statistics/cell_lags.h>

#include <algorithm>
#include <cmath>

namespace squeal::tribology
{
  CellLags::CellLags(const std::vector<CellColumnRow> &cells)
    : cells(cells)
  {
    for (const auto &[column, row] : cells)
      {
        n_columns = std::max(n_columns, column + 1);
        n_rows    = std::max(n_rows, row + 1);
      }
    counts = sums(Eigen::VectorXd::Ones(cells.size()));
  }



  Eigen::MatrixXd
  CellLags::on_rectangle(const Eigen::VectorXd &values) const
  {
    Eigen::MatrixXd map = Eigen::MatrixXd::Zero(n_columns, n_rows);
    for (std::size_t i = 0; i < cells.size(); ++i)
      map(cells[i][0], cells[i][1]) += values(i);
    return map;
  }



  double
  CellLags::largest_share_of_line(const Eigen::VectorXd &of_cells) const
  {
    const Eigen::MatrixXd map = on_rectangle(of_cells) / of_cells.sum();
    return std::max(map.rowwise().sum().maxCoeff(),
                    map.colwise().sum().maxCoeff());
  }



  Eigen::VectorXd
  CellLags::sums(const Eigen::VectorXd &of_cells) const
  {
    const Eigen::MatrixXd values = on_rectangle(of_cells);
    const Eigen::Index    wide = values.rows(), high = values.cols();
    Eigen::VectorXd       result(wide * high + (wide - 1) * (high - 1) + 1);
    Eigen::Index          lag = 0;
    for (Eigen::Index down = 0; down < high; ++down)
      for (Eigen::Index right = down == 0 ? 0 : 1 - wide; right < wide; ++right)
        {
          const Eigen::Index n = wide - std::abs(right);
          result(lag++) =
            values.block(std::max<Eigen::Index>(0, -right), 0, n, high - down)
              .cwiseProduct(values.block(
                std::max<Eigen::Index>(0, right), down, n, high - down))
              .sum();
        }
    // the square of a place's sum holds each pair of its cells twice
    const double own = of_cells.squaredNorm();
    result(lag)      = .5 * (result(0) - own);
    result(0)        = own;
    return result;
  }



  double
  CellLags::variance_of(const Eigen::VectorXd &a,
                        const Eigen::VectorXd &b) const
  {
    double sum = 0.;
    for (Eigen::Index lag = 0; lag < counts.size(); ++lag)
      if (counts(lag) > 0.)
        sum += (lag == 0 ? 1. : 2.) * a(lag) * b(lag) / counts(lag);
    return sum / (a(0) * b(0));
  }



  double
  CellLags::variance(const Eigen::VectorXd &x, const Eigen::VectorXd &y) const
  {
    return variance_of(sums(x), sums(y));
  }



  double
  CellLags::variance_in(const Eigen::MatrixXd &basis) const
  {
    Eigen::VectorXd all = Eigen::VectorXd::Zero(counts.size());
    for (Eigen::Index c = 0; c < basis.cols(); ++c)
      all += sums(basis.col(c));
    return variance_of(all, all);
  }
} // namespace squeal::tribology
