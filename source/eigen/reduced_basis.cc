// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/eigen/reduced_basis.h>

namespace squeal
{
  ReducedBasis::ReducedBasis(const Pencil &p)
    : pencil(p)
    , basis(p)
  {
    rayleigh = pencil.is_rayleigh_damped(alpha, beta);
    for (const auto &part : pencil.parts())
      {
        projected.push_back({Eigen::MatrixXd(0, 0), part.coefficients});
        products.emplace_back(pencil.space()->n_owned());
        transposed_products.emplace_back(pencil.space()->n_owned());
      }
  }



  unsigned int
  ReducedBasis::extend(const Block &new_directions)
  {
    const RowSpace &space = *pencil.space();
    const Block     W     = basis.extend(new_directions, 1e-9);
    const Eigen::Index b = W.cols(), n = basis.size() - b;
    for (std::size_t i = 0; i < projected.size(); ++i)
      {
        const auto &part = pencil.parts()[i];
        products[i].append(part.matrix->multiply(W));
        if (!part.symmetric)
          transposed_products[i].append(part.matrix->multiply_transposed(W));
        Eigen::MatrixXd A(n + b, n + b);
        A.topLeftCorner(n, n) = projected[i].matrix;
        A.rightCols(b)        = inner_products(space,
                                        basis.vectors(),
                                        products[i].view().rightCols(b));
        A.bottomLeftCorner(b, n) =
          part.symmetric ?
            Eigen::MatrixXd(A.topRightCorner(n, b).transpose()) :
            inner_products(space,
                           transposed_products[i].view().rightCols(b),
                           basis.vectors().leftCols(n));
        projected[i].matrix = A;
      }
    return b;
  }



  unsigned int
  ReducedBasis::size() const
  {
    return basis.size();
  }

  Eigen::Map<const Block>
  ReducedBasis::vectors() const
  {
    return basis.vectors();
  }

  const std::vector<ReducedPart> &
  ReducedBasis::parts() const
  {
    return projected;
  }

  DensePairs
  ReducedBasis::solve() const
  {
    return solve_dense_quadratic(projected, rayleigh, alpha, beta);
  }

  namespace
  {
    ComplexBlock
    combine_columns(const Eigen::Map<const Block> &V, const Eigen::MatrixXcd &z)
    {
      ComplexBlock X(V.rows(), z.cols());
      X.real() = V * z.real();
      X.imag() = V * z.imag();
      return X;
    }
  } // namespace

  ComplexBlock
  ReducedBasis::lift(const Eigen::MatrixXcd &z) const
  {
    return combine_columns(basis.vectors(), z);
  }

  Pencil::Products
  ReducedBasis::apply(const Eigen::MatrixXcd &z, const bool transposed) const
  {
    const Eigen::Index rows = basis.vectors().rows();
    Pencil::Products   result{ComplexBlock::Zero(rows, z.cols()),
                            ComplexBlock::Zero(rows, z.cols()),
                            ComplexBlock::Zero(rows, z.cols())};
    for (std::size_t i = 0; i < projected.size(); ++i)
      {
        const auto &part = pencil.parts()[i];
        const auto &c    = part.coefficients;
        const ComplexBlock Z =
          combine_columns(transposed && !part.symmetric ?
                            transposed_products[i].view() :
                            products[i].view(),
                          z);
        if (c.mass != 0.)
          result.mass += c.mass * Z;
        if (c.damping != 0.)
          result.damping += c.damping * Z;
        if (c.stiffness != 0.)
          result.stiffness += c.stiffness * Z;
      }
    return result;
  }
} // namespace squeal
