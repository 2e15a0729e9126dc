// SPDX-License-Identifier: LGPL-2.1-or-later
#include "random_of_row.h"

#include <squeal/eigen/reduced_basis.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>

namespace squeal
{
  namespace
  {
    /** A column whose products have no zero but where a matrix has an empty
     * row. Vectors of a basis may be zero on a part of the scene that others,
     * added later, move. */
    Block
    probe_of_rows(const RowSpace &space)
    {
      Block result(space.n_owned(), 1);
      for (unsigned int i = 0; i < space.n_owned(); ++i)
        result(i, 0) = 2. + random_of_row(space.first_owned() + i, 0);
      return result;
    }
  } // namespace



  ReducedBasis::ReducedBasis(const Pencil &p, const BasisProducts kept)
    : pencil(p)
    , basis(p, kept)
  {
    rayleigh = pencil.is_rayleigh_damped(alpha, beta);
    // Products of a lone mass and a lone stiffness come with the basis.
    mass_part = kept == BasisProducts::kept
                  ? lone_part([](const TermCoefficients &c) { return c.mass; })
                  : pencil.parts().size();
    stiffness_part =
      lone_part([](const TermCoefficients &c) { return c.stiffness.real(); });
    const Block probe = probe_of_rows(*pencil.space());
    for (std::size_t i = 0; i < pencil.parts().size(); ++i)
      {
        const auto &part = pencil.parts()[i];
        projected.push_back({Eigen::MatrixXd(0, 0), part.coefficients});
        products.emplace_back();
        transposed_products.emplace_back();
        if (!part.symmetric)
          {
            products[i].reach(part.matrix->multiply(probe).col(0));
            transposed_products[i].reach(
              part.matrix->multiply_transposed(probe).col(0));
          }
        else if (i != mass_part && basis.keeps_products())
          products[i].reach(part.matrix->multiply(probe).col(0));
      }
  }



  std::size_t
  ReducedBasis::lone_part(double (*coefficient)(const TermCoefficients &)) const
  {
    const auto &parts  = pencil.parts();
    std::size_t result = parts.size();
    for (std::size_t i = 0; i < parts.size(); ++i)
      if (parts[i].symmetric && coefficient(parts[i].coefficients) != 0.)
        {
          if (result < parts.size())
            return parts.size();
          result = i;
        }
    return result;
  }



  void
  ReducedBasis::Product::reach(const Eigen::VectorXd &A_probe)
  {
    for (Eigen::Index i = 0; i < A_probe.size(); ++i)
      if (A_probe[i] != 0.)
        rows.push_back(i);
    if (static_cast<Eigen::Index>(rows.size()) > A_probe.size() / 4)
      rows.clear();
    columns = GrowingBlock(rows.empty() ? A_probe.size() : rows.size());
  }

  void
  ReducedBasis::Product::append(const Eigen::Ref<const Block> &AW)
  {
    if (rows.empty())
      columns.append(AW);
    else
      columns.append(Block(AW(rows, Eigen::all)));
  }

  Eigen::MatrixXd
  ReducedBasis::Product::projected_on(const Eigen::Map<const Block> &X,
                                      const unsigned int n_last) const
  {
    const auto last = columns.view().rightCols(n_last);
    if (rows.empty())
      return X.transpose() * last;
    return Block(X(rows, Eigen::all)).transpose() * last;
  }



  void
  ReducedBasis::start(const Eigen::Ref<const Block> &W,
                      const Eigen::Ref<const Block> &MW,
                      const Eigen::Ref<const Block> &KW)
  {
    basis.adopt(W, MW);
    for (std::size_t i = 0; i < projected.size(); ++i)
      if (const double k = pencil.parts()[i].coefficients.stiffness.real();
          i == stiffness_part && k == 1.)
        append_symmetric(i, KW);
      else if (i == stiffness_part)
        append_symmetric(i, KW / k);
      else
        project(i, W);
  }

  unsigned int
  ReducedBasis::extend(Block new_directions)
  {
    const Block W = basis.extend(std::move(new_directions), 1e-9);
    for (std::size_t i = 0; i < projected.size(); ++i)
      project(i, W);
    return W.cols();
  }

  void
  ReducedBasis::project(const std::size_t i, const Block &W)
  {
    const RowSpace    &space = *pencil.space();
    const auto        &part  = pencil.parts()[i];
    const Eigen::Index b     = W.cols();
    if (i == mass_part)
      return grow(i,
                  inner_products(space,
                                 basis.vectors(),
                                 basis.mass_products().rightCols(b)) /
                    part.coefficients.mass,
                  {});
    if (part.symmetric)
      return append_symmetric(i, part.matrix->multiply(W));
    products[i].append(part.matrix->multiply(W));
    transposed_products[i].append(part.matrix->multiply_transposed(W));
    Eigen::MatrixXd right = products[i].projected_on(basis.vectors(), b);
    Eigen::MatrixXd below =
      transposed_products[i].projected_on(basis.vectors(), b);
    space.sum(right);
    space.sum(below);
    grow(i, right, below);
  }

  void
  ReducedBasis::append_symmetric(const std::size_t              i,
                                 const Eigen::Ref<const Block> &AW)
  {
    if (!basis.keeps_products())
      return grow(i, inner_products(*pencil.space(), basis.vectors(), AW), {});
    products[i].append(AW);
    Eigen::MatrixXd right =
      products[i].projected_on(basis.vectors(), AW.cols());
    pencil.space()->sum(right);
    grow(i, right, {});
  }

  void
  ReducedBasis::grow(const std::size_t      i,
                     const Eigen::MatrixXd &right,
                     const Eigen::MatrixXd &below)
  {
    const Eigen::Index b = right.cols(), n = right.rows() - b;
    Eigen::MatrixXd    A(n + b, n + b);
    A.topLeftCorner(n, n) = projected[i].matrix;
    A.rightCols(b)        = right;
    // Products of a stiff matrix with smooth vectors leave more rounding in a
    // product of vectors than symmetry allows: it would couple close pairs as
    // friction does.
    if (below.size() == 0)
      A.bottomRightCorner(b, b) =
        0.5 * (right.bottomRows(b) + right.bottomRows(b).transpose());
    A.bottomLeftCorner(b, n) =
      (below.size() > 0 ? below : right).topRows(n).transpose();
    projected[i].matrix = A;
  }



  void
  ReducedBasis::release_products()
  {
    products.clear();
    transposed_products.clear();
  }

  unsigned int
  ReducedBasis::size() const
  {
    return basis.size();
  }

  bool
  ReducedBasis::keeps_products() const
  {
    return basis.keeps_products();
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
    // A few at a time: bases are large.
    constexpr Eigen::Index chunk = 16;
    const auto             V     = basis.vectors().leftCols(z.rows());
    ComplexBlock           X(V.rows(), z.cols());
    for (Eigen::Index first = 0; first < z.cols(); first += chunk)
      {
        const Eigen::Index n = std::min(chunk, z.cols() - first);
        Eigen::MatrixXd    both(z.rows(), 2 * n);
        both << z.middleCols(first, n).real(), z.middleCols(first, n).imag();
        const Block product           = V * both;
        X.middleCols(first, n).real() = product.leftCols(n);
        X.middleCols(first, n).imag() = product.rightCols(n);
      }
    return X;
  }

  Block
  ReducedBasis::product_with(const std::size_t       i,
                             const bool              transposed,
                             const Eigen::MatrixXcd &z) const
  {
    // Coordinates of an earlier, smaller basis are the first of this one.
    Eigen::MatrixXd both(z.rows(), 2 * z.cols());
    both << z.real(), z.imag();
    if (i == mass_part)
      return basis.mass_products().leftCols(z.rows()) *
             (both / pencil.parts()[i].coefficients.mass);
    if (!basis.keeps_products() && pencil.parts()[i].symmetric)
      return pencil.parts()[i].matrix->multiply(
        Block(basis.vectors().leftCols(z.rows()) * both));
    const bool     other   = transposed && !pencil.parts()[i].symmetric;
    const Product &product = other ? transposed_products[i] : products[i];
    return product.columns.view().leftCols(z.rows()) * both;
  }

  Eigen::MatrixXd
  ReducedBasis::product_gram(const std::size_t i, const std::size_t j) const
  {
    Assert(basis.keeps_products(), dealii::ExcNotInitialized());
    // All rows of a product, in full only where it is.
    const auto columns = [&](const std::size_t k) {
      return k == mass_part ? basis.mass_products()
                            : products[k].columns.view();
    };
    const auto rows = [&](const std::size_t k) {
      return k == mass_part ? std::vector<Eigen::Index>() : products[k].rows;
    };
    const auto      a = rows(i), b = rows(j);
    Eigen::MatrixXd gram;
    if (a.empty() && b.empty())
      gram = columns(i).transpose() * columns(j);
    else if (a.empty())
      gram = Block(columns(i)(b, Eigen::all)).transpose() * columns(j);
    else if (b.empty())
      gram = columns(i).transpose() * Block(columns(j)(a, Eigen::all));
    else
      {
        std::vector<Eigen::Index> in_a, in_b;
        for (std::size_t p = 0, q = 0; p < a.size() && q < b.size();)
          if (a[p] == b[q])
            {
              in_a.push_back(p++);
              in_b.push_back(q++);
            }
          else
            (a[p] < b[q] ? p : q) += 1;
        gram = Block(columns(i)(in_a, Eigen::all)).transpose() *
               Block(columns(j)(in_b, Eigen::all));
      }
    pencil.space()->sum(gram);
    if (i == mass_part)
      gram /= pencil.parts()[i].coefficients.mass;
    if (j == mass_part)
      gram /= pencil.parts()[j].coefficients.mass;
    return gram;
  }

  PairResiduals
  ReducedBasis::residuals(const Eigen::VectorXcd &lambda,
                          const Eigen::MatrixXcd &z,
                          const bool              transposed) const
  {
    std::vector<TermCoefficients> own;
    for (const auto &part : pencil.parts())
      own.push_back(part.coefficients);
    return residuals(own, lambda, z, transposed);
  }

  PairResiduals
  ReducedBasis::residuals(const std::vector<TermCoefficients> &coefficients,
                          const Eigen::VectorXcd              &lambda,
                          const Eigen::MatrixXcd              &z,
                          const bool                           transposed) const
  {
    return residuals(
      std::vector<std::vector<TermCoefficients>>(z.cols(), coefficients),
      lambda,
      z,
      transposed);
  }

  PairResiduals
  ReducedBasis::residuals(
    const std::vector<std::vector<TermCoefficients>> &of_pairs,
    const Eigen::VectorXcd                           &lambda,
    const Eigen::MatrixXcd                           &z,
    const bool                                        transposed) const
  {
    // A few pairs at a time, one after the other: all that one needs stays in
    // the cache.
    constexpr Eigen::Index chunk  = 16;
    const Eigen::Index     n_rows = basis.vectors().rows(), n = z.cols();
    PairResiduals          result{
      ComplexBlock(n_rows, n), Eigen::VectorXd(n), Eigen::VectorXd(n)};
    Eigen::MatrixXd squares(4, n); // of M x, C x, K x and r
    for (Eigen::Index first = 0; first < n; first += chunk)
      {
        const Eigen::Index n_chunk = std::min(chunk, n - first);
        std::vector<Block> own;
        for (std::size_t i = 0; i < projected.size(); ++i)
          own.push_back(
            std::all_of(of_pairs.begin() + first,
                        of_pairs.begin() + first + n_chunk,
                        [i](const auto &c) { return c[i].is_zero(); })
              ? Block()
              : product_with(i, transposed, z.middleCols(first, n_chunk)));
        for (Eigen::Index k = 0; k < n_chunk; ++k)
          {
            Eigen::VectorXcd Mx = Eigen::VectorXcd::Zero(n_rows), Cx = Mx,
                             Kx = Mx;
            for (std::size_t i = 0; i < projected.size(); ++i)
              {
                const auto &c = of_pairs[first + k][i];
                if (c.is_zero())
                  continue;
                const auto  re    = own[i].col(k);
                const auto  im    = own[i].col(n_chunk + k);
                const bool  other = transposed && !pencil.parts()[i].symmetric;
                const auto &rows =
                  (other ? transposed_products : products)[i].rows;
                const auto add_to = [&](Eigen::VectorXcd          &x,
                                        const std::complex<double> factor) {
                  if (factor == 0.)
                    return;
                  if (rows.empty() && factor.imag() == 0.)
                    {
                      x.real() += factor.real() * re;
                      x.imag() += factor.real() * im;
                    }
                  else if (rows.empty())
                    for (Eigen::Index r = 0; r < n_rows; ++r)
                      x[r] += factor * std::complex<double>(re[r], im[r]);
                  else
                    for (std::size_t r = 0; r < rows.size(); ++r)
                      x[rows[r]] += factor * std::complex<double>(re[r], im[r]);
                };
                add_to(Mx, c.mass);
                add_to(Cx, c.damping);
                add_to(Kx, c.stiffness);
              }
            const Eigen::Index         j = first + k;
            const std::complex<double> l = lambda[j];
            result.vectors.col(j)        = l * l * Mx + l * Cx + Kx;
            squares.col(j) << Mx.squaredNorm(), Cx.squaredNorm(),
              Kx.squaredNorm(), result.vectors.col(j).squaredNorm();
          }
      }
    pencil.space()->sum(squares);
    const Eigen::ArrayXd  size  = lambda.array().abs();
    const Eigen::MatrixXd norms = squares.cwiseSqrt();
    result.denominators = size.square() * norms.row(0).transpose().array() +
                          size * norms.row(1).transpose().array() +
                          norms.row(2).transpose().array();
    result.relative = norms.row(3).transpose().array() /
                      result.denominators.array().max(1e-300);
    return result;
  }
} // namespace squeal
