// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/low_rank_matrix.h>
#include <squeal/base/sum_operator.h>
#include <squeal/eigen/mass_basis.h>
#include <squeal/eigen/sliding_inverse.h>

namespace squeal
{
  namespace
  {
    /** Rows beyond which the responses cost more than they save. */
    constexpr unsigned int maximum_rank = 600;
  } // namespace



  SlidingInverse::SlidingInverse(const Pencil &pencil, const ShiftedInverse &s)
    : space(pencil.space())
    , inverse(s)
  {
    collect(pencil);
    if (terms.empty())
      return;
    Block columns_of_all(space->n_owned(), 0);
    for (const Term &term : terms)
      {
        const Functionals &left = term.friction->left_rows();
        const Block        columns =
          inverse.solve(left.apply_transposed(Eigen::MatrixXd(
            Eigen::MatrixXd::Identity(left.n_rows(), left.n_rows()))));
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
    , responses(other.responses)
  {
    collect(pencil);
    bool alike = terms.size() == other.terms.size();
    for (std::size_t i = 0; alike && i < terms.size(); ++i)
      alike = terms[i].friction == other.terms[i].friction;
    // Without friction, or with another one, the plain inverse remains.
    if (!alike)
      terms.clear();
    if (!terms.empty())
      factorize_capacitance();
  }

  void
  SlidingInverse::factorize_capacitance()
  {
    Eigen::MatrixXd C = forces(*responses);
    C.diagonal().array() += 1.;
    capacitance.compute(C);
  }



  void
  SlidingInverse::collect(const Pencil &pencil)
  {
    unsigned int n_rows = 0;
    const auto   add    = [&](const double factor, const LinearOperator *a) {
      const auto *friction = dynamic_cast<const LowRankOperator *>(a);
      if (friction && factor != 0.)
        {
          terms.push_back({factor, friction});
          n_rows += friction->left_rows().n_rows();
        }
    };
    for (const auto &part : pencil.parts())
      {
        const double factor = part.coefficients.stiffness.real() -
                              inverse.shift() * part.coefficients.mass;
        if (part.symmetric)
          continue;
        if (const auto *sum =
              dynamic_cast<const SumOperator *>(part.matrix.get()))
          for (const auto &[weight, summand] : sum->summands())
            add(factor * weight, summand.get());
        else
          add(factor, part.matrix.get());
      }
    if (n_rows > maximum_rank)
      terms.clear();
  }



  Eigen::MatrixXd
  SlidingInverse::forces(const Block &X) const
  {
    std::vector<Eigen::MatrixXd> parts;
    Eigen::Index                 n = 0;
    for (const Term &term : terms)
      {
        parts.push_back(term.factor * term.friction->forces(X));
        n += parts.back().rows();
      }
    Eigen::MatrixXd all(n, X.cols());
    Eigen::Index    first = 0;
    for (const auto &part : parts)
      {
        all.middleRows(first, part.rows()) = part;
        first += part.rows();
      }
    return all;
  }

  Block
  SlidingInverse::transposed_forces(const Eigen::MatrixXd &g) const
  {
    Block        result = Block::Zero(responses->rows(), g.cols());
    Eigen::Index first  = 0;
    for (const Term &term : terms)
      {
        const Eigen::Index n = term.friction->left_rows().n_rows();
        result += term.factor * term.friction->transposed_forces(
                                  Eigen::MatrixXd(g.middleRows(first, n)));
        first += n;
      }
    return result;
  }



  Block
  SlidingInverse::solve(const Block &b) const
  {
    Block x = inverse.solve(b);
    if (!terms.empty())
      x.noalias() -= *responses * capacitance.solve(forces(x));
    return x;
  }

  Block
  SlidingInverse::solve_transposed(const Block &b) const
  {
    if (terms.empty() || b.cols() == 0)
      return inverse.solve(b);
    // L S b = (S L^T)^T b needs no solve of its own.
    const Eigen::MatrixXd g =
      capacitance.transpose().solve(inner_products(*space, *responses, b));
    return inverse.solve(Block(b - transposed_forces(g)));
  }
} // namespace squeal
