// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/low_rank_matrix.h>
#include <squeal/base/sum_operator.h>
#include <squeal/eigen/mass_basis.h>
#include <squeal/eigen/sliding_inverse.h>

#include <algorithm>

namespace squeal
{
  namespace
  {
    /** Rows beyond which the responses cost more than they save; fewer where
     * the factors are on disk: the memory is short. */
    constexpr unsigned int maximum_rank = 600, maximum_rank_on_disk = 200;
  } // namespace



  SlidingInverse::SlidingInverse(const Pencil &pencil, const ShiftedInverse &s)
    : space(pencil.space())
    , inverse(s)
  {
    for (const auto &part : pencil.parts())
      factored.push_back(part.coefficients);
    rows                = collect(pencil, factored);
    unsigned int n_rows = 0;
    for (const Rows &own : rows)
      n_rows += own.left->n_rows();
    if (n_rows > (inverse.place() == FactorPlace::disk ? maximum_rank_on_disk
                                                       : maximum_rank))
      rows.clear();
    if (rows.empty())
      return;
    Block columns_of_all(space->n_owned(), 0);
    for (const Rows &own : rows)
      {
        const Block columns = inverse.solve(
          own.left->apply_transposed(Eigen::MatrixXd(Eigen::MatrixXd::Identity(
            own.left->n_rows(), own.left->n_rows()))));
        columns_of_all.conservativeResize(
          Eigen::NoChange, columns_of_all.cols() + columns.cols());
        columns_of_all.rightCols(columns.cols()) = columns;
      }
    responses = std::make_shared<const Block>(std::move(columns_of_all));
    factorize_capacitance();
  }

  SlidingInverse::SlidingInverse(const Pencil         &pencil,
                                 const SlidingInverse &other)
    : space(other.space)
    , inverse(other.inverse)
    , factored(other.factored)
    , responses(other.responses)
  {
    if (other.rows.empty() || pencil.parts().size() != factored.size())
      return;
    const std::vector<Rows> own = collect(pencil, factored);
    rows                        = other.rows;
    for (Rows &r : rows)
      r.terms.clear();
    for (const Rows &r : own)
      {
        const auto same =
          std::find_if(rows.begin(), rows.end(), [&](const Rows &known) {
            return known.left == r.left;
          });
        if (same == rows.end())
          {
            rows.clear();
            return;
          }
        same->terms = r.terms;
      }
    factorize_capacitance();
  }

  void
  SlidingInverse::factorize_capacitance()
  {
    Eigen::MatrixXd C = forces(*responses);
    C.diagonal().array() += 1.;
    capacitance.compute(C);
  }



  std::vector<SlidingInverse::Rows>
  SlidingInverse::collect(const Pencil                        &pencil,
                          const std::vector<TermCoefficients> &of_factor) const
  {
    std::vector<Rows> result;
    const auto        add = [&](const double factor, const LinearOperator *a) {
      const auto *low = dynamic_cast<const LowRankOperator *>(a);
      if (!low)
        return;
      const Functionals *left = &low->left_rows();
      auto               same = std::find_if(result.begin(),
                               result.end(),
                               [&](const Rows &r) { return r.left == left; });
      if (same == result.end())
        same = result.insert(result.end(), Rows{left, {}});
      if (factor != 0.)
        same->terms.emplace_back(factor, low);
    };
    const auto strength = [&](const TermCoefficients &c) {
      return c.stiffness.real() - inverse.shift() * c.mass;
    };
    for (std::size_t i = 0; i < pencil.parts().size(); ++i)
      {
        const auto &part   = pencil.parts()[i];
        double      factor = strength(part.coefficients);
        if (part.symmetric)
          {
            // Only what comes and goes with the contact state.
            if (!of_factor[i].is_zero() && !part.coefficients.is_zero())
              continue;
            factor -= strength(of_factor[i]);
          }
        if (const auto *sum =
              dynamic_cast<const SumOperator *>(part.matrix.get()))
          for (const auto &[weight, summand] : sum->summands())
            add(factor * weight, summand.get());
        else
          add(factor, part.matrix.get());
      }
    return result;
  }



  Eigen::MatrixXd
  SlidingInverse::forces(const Block &X) const
  {
    Eigen::Index n = 0;
    for (const Rows &own : rows)
      n += own.left->n_rows();
    Eigen::MatrixXd all   = Eigen::MatrixXd::Zero(n, X.cols());
    Eigen::Index    first = 0;
    for (const Rows &own : rows)
      {
        for (const auto &[factor, term] : own.terms)
          all.middleRows(first, own.left->n_rows()) += factor * term->forces(X);
        first += own.left->n_rows();
      }
    return all;
  }

  Block
  SlidingInverse::transposed_forces(const Eigen::MatrixXd &g) const
  {
    Block        result = Block::Zero(responses->rows(), g.cols());
    Eigen::Index first  = 0;
    for (const Rows &own : rows)
      {
        const Eigen::MatrixXd part = g.middleRows(first, own.left->n_rows());
        for (const auto &[factor, term] : own.terms)
          result += factor * term->transposed_forces(part);
        first += own.left->n_rows();
      }
    return result;
  }



  Block
  SlidingInverse::solve(const Block &b) const
  {
    Block x = inverse.solve(b);
    if (!rows.empty())
      x.noalias() -= *responses * capacitance.solve(forces(x));
    return x;
  }

  Block
  SlidingInverse::solve_transposed(const Block &b) const
  {
    if (rows.empty() || b.cols() == 0)
      return inverse.solve(b);
    // L S b = (S L^T)^T b needs no solve of its own.
    const Eigen::MatrixXd g =
      capacitance.transpose().solve(inner_products(*space, *responses, b));
    return inverse.solve(Block(b - transposed_forces(g)));
  }
} // namespace squeal
