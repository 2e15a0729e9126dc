// SPDX-License-Identifier: LGPL-2.1-or-later
#include "residual_directions.h"

#include <squeal/eigen/mass_basis.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace squeal
{
  Block
  compress(const RowSpace        &space,
           ComplexBlock          &Z,
           const Eigen::VectorXd &scales,
           const double           limit)
  {
    Block        R(Z.rows(), 2 * Z.cols());
    Eigen::Index n_columns = 0;
    for (Eigen::Index j = 0; j < Z.cols(); ++j)
      if (scales[j] > 0.)
        {
          R.col(n_columns++) = Z.col(j).real() / scales[j];
          R.col(n_columns++) = Z.col(j).imag() / scales[j];
        }
    Z.resize(0, 0);
    if (n_columns == 0)
      return Block(R.rows(), 0);
    const auto used = R.leftCols(n_columns);
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> gram(
      inner_products(space, used, used));
    const Eigen::VectorXd &values = gram.eigenvalues();
    const double           smallest =
      std::max(limit, 1e-4 * std::sqrt(values.maxCoeff()));
    Eigen::Index first = 0;
    while (first < values.size() && values[first] < smallest * smallest)
      ++first;
    const Eigen::Index n = values.size() - first;
    return used * Eigen::MatrixXd(
                    gram.eigenvectors().rightCols(n) *
                    values.tail(n).cwiseSqrt().cwiseInverse().asDiagonal());
  }
} // namespace squeal
