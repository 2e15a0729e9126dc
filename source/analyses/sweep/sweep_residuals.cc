// SPDX-License-Identifier: LGPL-2.1-or-later

// residual_rel of a sweep's pairs, without the full vectors.

#include <squeal/analyses/sweep/sweep_model.h>
#include <squeal/base/dense_products.h>

#include <cmath>

namespace squeal
{
  namespace
  {
    using Complex = std::complex<double>;
  }

  Eigen::VectorXd
  SweepModel::residuals(const SweepPoint   &point,
                        const ComplexPairs &pairs) const
  {
    if (small.grams.empty())
      return {};
    const auto        c      = parts.coefficients(point);
    const ModelCell  &cell   = small.cell_of(point);
    const auto        V      = cell.turn.leftCols(cell.local.n_basis);
    const std::size_t number = &cell - small.cells.data();
    auto             &grams  = cell_grams[number];
    if (grams.empty() || grams.front().rows() != V.cols())
      {
        grams.clear();
        for (const auto &gram : small.grams)
          grams.push_back(
            gram.size() > 0 ? Eigen::MatrixXd(V.transpose() * gram * V) : gram);
      }
    const Eigen::MatrixXcd z = times(V.transpose(), pairs.right);
    // |sum of f_p A_p x|^2 for the factors of the residual, of M, C and K.
    Eigen::MatrixXd squares = Eigen::MatrixXd::Zero(4, pairs.size());
    std::size_t     k       = 0;
    for (std::size_t p = 0; p < c.size(); ++p)
      for (std::size_t q = p; q < c.size(); ++q, ++k)
        {
          const Eigen::MatrixXcd g = times(grams[k], z);
          for (unsigned int j = 0; j < pairs.size(); ++j)
            {
              const Complex l     = pairs.lambda[j];
              const Complex value = z.col(j).dot(g.col(j));
              const auto    add =
                [&](const int row, const Complex a, const Complex b) {
                  squares(row, j) +=
                    (p == q ? 1. : 2.) * (std::conj(a) * b * value).real();
                };
              const auto whole = [&](const TermCoefficients &t) {
                return l * l * t.mass + l * t.damping + t.stiffness;
              };
              add(0, whole(c[p]), whole(c[q]));
              add(1, c[p].mass, c[q].mass);
              add(2, c[p].damping, c[q].damping);
              add(3, c[p].stiffness, c[q].stiffness);
            }
        }
    const Eigen::MatrixXd norms = squares.cwiseMax(0.).cwiseSqrt();
    const Eigen::ArrayXd  size  = pairs.lambda.array().abs();
    return norms.row(0).transpose().array() /
           (size.square() * norms.row(1).transpose().array() +
            size * norms.row(2).transpose().array() +
            norms.row(3).transpose().array())
             .max(1e-300);
  }
} // namespace squeal
