// SPDX-License-Identifier: LGPL-2.1-or-later

// Operators agree with dense matrices: products, transposed products,
// entrywise absolute products and the entries they give away.

#include "check.h"

#include <squeal/base/low_rank_matrix.h>
#include <squeal/base/sparse_matrix.h>
#include <squeal/base/sum_operator.h>

#include <deal.II/base/mpi.h>

#include <Eigen/Dense>

using namespace squeal;
using squeal::testing::check;

namespace
{
  constexpr int n = 9;

  Eigen::MatrixXd
  dense(const LinearOperator &A, const double factor, const bool lower_only)
  {
    Triplets t;
    A.append_to(t, factor, lower_only);
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero(n, n);
    for (std::size_t k = 0; k < t.values.size(); ++k)
      result(t.rows[k], t.columns[k]) += t.values[k];
    return result;
  }

  void
  check_equal(const Eigen::MatrixXd &a,
              const Eigen::MatrixXd &b,
              const std::string     &text)
  {
    check(a.rows() == b.rows() && a.cols() == b.cols() &&
            (a - b).norm() <= 1e-14 * (1. + b.norm()),
          text);
  }

  void
  check_operator(const LinearOperator  &A,
                 const Eigen::MatrixXd &D,
                 const std::string     &name)
  {
    // 1, 8 and 19 columns: products run in chunks.
    for (const int columns : {1, 8, 19})
      {
        const Block X = Block::Random(n, columns);
        check_equal(A.multiply(X), D * X, name + ": A X");
        check_equal(
          A.multiply_transposed(X), D.transpose() * X, name + ": A^T X");
      }
    const Block X     = Block::Random(n, 3);
    const Block bound = D.cwiseAbs() * X.cwiseAbs();
    check((A.multiply_absolute(X) - bound).minCoeff<Eigen::PropagateNaN>() >=
            -1e-14,
          name + ": multiply_absolute bounds |A| |X|");
    check_equal(dense(A, 2.5, false), 2.5 * D, name + ": all entries");
    check(A.is_symmetric() == D.isApprox(D.transpose()),
          name + ": is_symmetric");
    if (A.is_symmetric())
      check_equal(dense(A, -0.5, true),
                  -0.5 * Eigen::MatrixXd(D.triangularView<Eigen::Lower>()),
                  name + ": lower entries");
  }

  /** About a third of the lower triangle, with duplicates. */
  Triplets
  some_entries(const bool diagonal)
  {
    Triplets t;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j <= i; ++j)
        if ((i != j || diagonal) && (i * 7 + j * 5) % 3 == 0)
          {
            t.add(i, j, std::sin(1. + i + 2.3 * j));
            t.add(i, j, 0.1);
          }
    return t;
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize init(argc, argv, 1);
  const auto space = std::make_shared<RowSpace>(n);

  for (const bool skew : {false, true})
    {
      const Triplets  t = some_entries(!skew);
      Eigen::MatrixXd D = Eigen::MatrixXd::Zero(n, n);
      for (std::size_t k = 0; k < t.values.size(); ++k)
        {
          D(t.rows[k], t.columns[k]) += t.values[k];
          if (t.rows[k] != t.columns[k])
            D(t.columns[k], t.rows[k]) += (skew ? -1. : 1.) * t.values[k];
        }
      const auto kind =
        skew ? SparseMatrix::Symmetry::skew : SparseMatrix::Symmetry::symmetric;
      SparseMatrix A(space, t, kind);
      check_operator(A, D, skew ? "skew" : "symmetric");
      check_equal(A.multiply_absolute(Block::Ones(n, 1)),
                  D.cwiseAbs() * Block::Ones(n, 1),
                  "|A| 1 exactly");

      const SparseMatrix B(space, t, kind);
      check(A.same_pattern(B), "same pattern");
      A.add(-3., B);
      check_operator(A, -2. * D, "after add");
    }

  std::vector<Functionals::Row> left_rows  = {{{0, 1.}, {4, -2.}},
                                              {{8, .5}},
                                              {},
                                              {{1, 1.}, {2, 1.}, {3, 3.}}},
                                right_rows = {{{7, 1.}},
                                              {{0, 1.}, {8, 1.}},
                                              {{3, 1.}},
                                              {{5, -1.}, {6, 1.}}};
  const auto      L  = std::make_shared<const Functionals>(space, left_rows);
  const auto      R  = std::make_shared<const Functionals>(space, right_rows);
  Eigen::MatrixXd DL = Eigen::MatrixXd::Zero(4, n), DR = DL;
  for (int r = 0; r < 4; ++r)
    {
      for (const auto &[c, v] : left_rows[r])
        DL(r, c) += v;
      for (const auto &[c, v] : right_rows[r])
        DR(r, c) += v;
    }
  const Eigen::Vector4d weights(1., 2., -3., .25);
  check_equal(L->apply(Block(Block::Identity(n, n))), DL, "functionals: B X");
  check_equal(L->apply_transposed(Eigen::MatrixXd(Eigen::Matrix4d::Identity())),
              DL.transpose(),
              "functionals: B^T G");
  const LowRankMatrix   general(L, weights, R), symmetric(L, weights, L);
  const Eigen::MatrixXd G = DL.transpose() * weights.asDiagonal() * DR;
  check_operator(general, G, "low rank");
  check_operator(symmetric,
                 DL.transpose() * weights.asDiagonal() * DL,
                 "symmetric low rank");

  const auto A =
    std::make_shared<const SparseMatrix>(space, some_entries(true));
  const SumOperator sum(
    {{2., A}, {-1., std::make_shared<const LowRankMatrix>(L, weights, R)}});
  check_operator(sum, 2. * dense(*A, 1., false) - G, "sum");
  return 0;
}
