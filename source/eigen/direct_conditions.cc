// SPDX-License-Identifier: LGPL-2.1-or-later

// Left vectors of the direct solver and the conditions that follow from them.

#include "dominant_eigenvalues.h"

#include <squeal/eigen/direct_solver.h>
#include <squeal/eigen/eigenvalue_condition.h>

#include <Eigen/LU>

#include <cmath>

namespace squeal
{
  namespace
  {
    using Complex = std::complex<double>;

    /** More left vectors than right ones: of those that are equally far from
     * the shift others may come last. */
    constexpr unsigned int n_spare = 4;
    /** Of the distance to the shift: how far the two solutions may differ, by
     * the root of rounding next to a coalescence. */
    constexpr double same_eigenvalue = 1e-5;
    /** Of |lambda|: eigenvalues whose vectors are any of one plane. */
    constexpr double multiple = 1e-9;

    /** Sum over all ranks of Y^T X. */
    Eigen::MatrixXcd
    transposed_product(const RowSpace     &space,
                       const ComplexBlock &Y,
                       const ComplexBlock &X)
    {
      const Eigen::MatrixXcd own = Y.transpose() * X;
      Eigen::MatrixXd        re = own.real(), im = own.imag();
      space.sum(re);
      space.sum(im);
      return re.cast<Complex>() + Complex(0., 1.) * im.cast<Complex>();
    }

    /** Norms of the columns with the mass. */
    Eigen::VectorXd
    mass_norms(const Pencil &pencil, const ComplexBlock &X)
    {
      Eigen::MatrixXd squares =
        X.conjugate().cwiseProduct(pencil.apply(X).mass).real().colwise().sum();
      pencil.space()->sum(squares);
      return squares.row(0).cwiseMax(0.).cwiseSqrt();
    }
  } // namespace



  Eigen::VectorXcd
  DirectSolver::apply_transposed(const Eigen::VectorXcd &z) const
  {
    const double       scale = scale_of_rate();
    const Eigen::Index n     = z.size() / 2;
    const ComplexBlock w     = left_vectors(z);
    const auto         p     = pencil.apply_transposed(w);
    Eigen::VectorXcd   result(2 * n);
    result << p.damping + shift * p.mass + z.tail(n) / scale, scale * p.mass;
    return result;
  }

  ComplexBlock
  DirectSolver::left_vectors(const ComplexBlock &Z) const
  {
    const Eigen::Index n = Z.rows() / 2;
    return -factor->solve_transposed(
      ComplexBlock(Z.topRows(n) + (shift / scale_of_rate()) * Z.bottomRows(n)));
  }



  void
  DirectSolver::find_conditions(ComplexPairs &pairs,
                                const double  tolerance) const
  {
    const Eigen::Index k     = pairs.size();
    const RowSpace    &space = *pencil.space();
    if (k == 0)
      return;
    Eigen::VectorXcd values;
    Eigen::MatrixXcd vectors;
    dominant_eigenvalues(
      [this](const Eigen::VectorXcd &z) { return apply_transposed(z); },
      space,
      std::min<unsigned int>(k + n_spare, 2 * space.n_global()),
      tolerance,
      std::abs(shift),
      values,
      vectors);

    std::vector<Eigen::Index> own, partner;
    std::vector<bool>         is_taken(values.size(), false);
    for (Eigen::Index i = 0; i < k; ++i)
      {
        Eigen::Index best = -1;
        double distance   = same_eigenvalue * std::abs(pairs.lambda[i] - shift);
        for (Eigen::Index j = 0; j < values.size(); ++j)
          if (const double d =
                std::abs(shift + 1. / values[j] - pairs.lambda[i]);
              !is_taken[j] && d <= distance)
            {
              best     = j;
              distance = d;
            }
        if (best < 0)
          continue;
        is_taken[best] = true;
        own.push_back(i);
        partner.push_back(best);
      }

    const ComplexBlock     X      = pairs.right(Eigen::all, own);
    ComplexBlock           Y      = left_vectors(vectors(Eigen::all, partner));
    const auto             p      = pencil.apply(X);
    const Eigen::VectorXcd lambda = pairs.lambda(own);
    const Eigen::MatrixXcd products = transposed_product(
      space, Y, 2. * (p.mass * lambda.asDiagonal()) + p.damping);
    const Eigen::MatrixXcd gram =
      transposed_product(space, Y.conjugate(), pencil.apply(Y).mass);
    const Eigen::VectorXd right_norms = mass_norms(pencil, X);
    for (std::size_t i = 0; i < own.size(); ++i)
      {
        // Of a multiple eigenvalue the left vector that belongs to this right
        // one: y^T Q' x_j = 0 for the others.
        std::vector<Eigen::Index> group = {static_cast<Eigen::Index>(i)};
        for (std::size_t j = 0; j < own.size(); ++j)
          if (j != i &&
              std::abs(lambda[j] - lambda[i]) <= multiple * std::abs(lambda[i]))
            group.push_back(j);
        const Eigen::MatrixXcd G = products(group, group);
        const Eigen::VectorXcd combination =
          Eigen::FullPivLU<Eigen::MatrixXcd>(G.transpose())
            .solve(Eigen::VectorXcd::Unit(group.size(), 0));
        const double square =
          combination.dot(gram(group, group) * combination).real();
        pairs.condition[own[i]] =
          eigenvalue_condition(lambda[i],
                               right_norms[i] * std::sqrt(std::max(square, 0.)),
                               (combination.transpose() * G)(0));
      }
  }
} // namespace squeal
