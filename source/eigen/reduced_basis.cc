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
        products.emplace_back();
        transposed_products.emplace_back();
      }
  }



  void
  ReducedBasis::Product::append(const Block &AW)
  {
    if (columns.n_columns() == 0)
      {
        for (Eigen::Index i = 0; i < AW.rows(); ++i)
          if (!AW.row(i).isZero(0.))
            rows.push_back(i);
        if (static_cast<Eigen::Index>(rows.size()) > AW.rows() / 4)
          rows.clear();
        columns = GrowingBlock(rows.empty() ? AW.rows() : rows.size());
      }
    if (rows.empty())
      columns.append(AW);
    else
      columns.append(Block(AW(rows, Eigen::all)));
  }

  void
  ReducedBasis::Product::add_to(const Eigen::MatrixXcd &z,
                                ComplexBlock           &result) const
  {
    // Coordinates of an earlier, smaller basis are the first of this one.
    const Eigen::Index n = z.cols();
    Eigen::MatrixXd    both(z.rows(), 2 * n);
    both << z.real(), z.imag();
    const Block product = columns.view().leftCols(z.rows()) * both;
    if (rows.empty())
      {
        result.real() += product.leftCols(n);
        result.imag() += product.rightCols(n);
        return;
      }
    for (std::size_t k = 0; k < rows.size(); ++k)
      {
        result.row(rows[k]).real() += product.row(k).head(n);
        result.row(rows[k]).imag() += product.row(k).tail(n);
      }
  }



  unsigned int
  ReducedBasis::extend(const Block &new_directions)
  {
    const RowSpace    &space = *pencil.space();
    const Block        W     = basis.extend(new_directions, 1e-9);
    const Eigen::Index b = W.cols(), n = basis.size() - b;
    for (std::size_t i = 0; i < projected.size(); ++i)
      {
        const auto &part = pencil.parts()[i];
        const Block AW   = part.matrix->multiply(W);
        products[i].append(AW);
        Eigen::MatrixXd A(n + b, n + b);
        A.topLeftCorner(n, n) = projected[i].matrix;
        A.rightCols(b)        = inner_products(space, basis.vectors(), AW);
        if (part.symmetric)
          A.bottomLeftCorner(b, n) = A.topRightCorner(n, b).transpose();
        else
          {
            const Block AtW = part.matrix->multiply_transposed(W);
            transposed_products[i].append(AtW);
            A.bottomLeftCorner(b, n) =
              inner_products(space, AtW, basis.vectors().leftCols(n));
          }
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

  ComplexBlock
  ReducedBasis::lift(const Eigen::MatrixXcd &z) const
  {
    const Eigen::Index n = z.cols();
    Eigen::MatrixXd    both(z.rows(), 2 * n);
    both << z.real(), z.imag();
    const Block  product = basis.vectors().leftCols(z.rows()) * both;
    ComplexBlock X(product.rows(), n);
    X.real() = product.leftCols(n);
    X.imag() = product.rightCols(n);
    return X;
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
        const auto    &part = pencil.parts()[i];
        const auto    &c    = part.coefficients;
        const Product &product =
          transposed && !part.symmetric ? transposed_products[i] : products[i];
        // One product serves the two matrices that a damped part adds to.
        ComplexBlock own = ComplexBlock::Zero(rows, z.cols());
        product.add_to(z, own);
        if (c.mass != 0.)
          result.mass += c.mass * own;
        if (c.damping != 0.)
          result.damping += c.damping * own;
        if (c.stiffness != 0.)
          result.stiffness += c.stiffness * own;
      }
    return result;
  }
} // namespace squeal
