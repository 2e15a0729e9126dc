// SPDX-License-Identifier: LGPL-2.1-or-later

// Elimination of dependent unknowns against dense matrices: u = P v, P^T f,
// P^T A P, and the friction L^T E_s^T A P of the recovered multipliers.

#include "worst.h"

#include <squeal/base/sparse_matrix.h>
#include <squeal/base/sum_operator.h>
#include <squeal/contact/elimination.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/mpi.h>

#include <Eigen/Dense>

#include <algorithm>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  constexpr int n = 7;

  /** The map and the same as dense matrices. */
  struct Case
  {
    explicit Case(const DependentUnknowns &d)
      : dependent(d)
      , space(std::make_shared<const RowSpace>(n))
      , elimination(std::make_shared<const Elimination>(space, d))
    {
      std::vector<int> number(n, -1);
      int              next = 0;
      for (int i = 0; i < n; ++i)
        if (std::find(d.rows.begin(), d.rows.end(), unsigned(i)) ==
            d.rows.end())
          number[i] = next++;
      P = Eigen::MatrixXd::Zero(n, next);
      for (int i = 0; i < n; ++i)
        if (number[i] >= 0)
          P(i, number[i]) = 1.;
      for (std::size_t k = 0; k < d.rows.size(); ++k)
        {
          for (const auto &[row, weight] : d.combinations[k])
            P(d.rows[k], number[row]) += weight;
        }
    }

    DependentUnknowns                  dependent;
    std::shared_ptr<const RowSpace>    space;
    std::shared_ptr<const Elimination> elimination;
    Eigen::MatrixXd                    P;
  };

  void
  check_equal(const Eigen::MatrixXd &a,
              const Eigen::MatrixXd &b,
              const std::string     &text)
  {
    check(a.rows() == b.rows() && a.cols() == b.cols() &&
            (a - b).norm() <= 1e-14 * (1. + b.norm()),
          text);
  }

  Eigen::MatrixXd
  dense(const Triplets &t, const Eigen::Index size)
  {
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero(size, size);
    for (std::size_t k = 0; k < t.values.size(); ++k)
      result(t.rows[k], t.columns[k]) += t.values[k];
    return result;
  }

  /** A symmetric matrix with some entries zero. */
  Eigen::MatrixXd
  some_matrix()
  {
    Eigen::MatrixXd A = Eigen::MatrixXd::Random(n, n);
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
        if ((i + j) % 3 == 1)
          A(i, j) = 0.;
    return A + A.transpose();
  }

  Triplets
  lower_entries(const Eigen::MatrixXd &A)
  {
    Triplets t;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j <= i; ++j)
        if (A(i, j) != 0.)
          t.add(i, j, A(i, j));
    return t;
  }

  Eigen::MatrixXd
  as_dense(const Functionals &f, const Eigen::Index n_columns)
  {
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero(f.n_rows(), n_columns);
    for (unsigned int r = 0; r < f.n_rows(); ++r)
      for (const auto &[column, weight] : f.rows()[r])
        result(r, column) += weight;
    return result;
  }

  void
  check_operators(const Case &c, const std::string &text)
  {
    const Eigen::Index    m = c.P.cols();
    const Eigen::MatrixXd A = some_matrix();
    const auto            matrix =
      std::make_shared<const SparseMatrix>(c.space, lower_entries(A));
    const EliminatedOperator reduced(matrix, c.elimination);
    const Eigen::MatrixXd    PAP = c.P.transpose() * A * c.P;
    const Block              X   = Block::Random(m, 3);
    check_equal(reduced.multiply(X), PAP * X, text + ": P^T A P X");
    check_equal(
      reduced.multiply_transposed(X), PAP * X, text + ": the transposed");
    for (const bool lower : {false, true})
      {
        Triplets t;
        reduced.append_to(t, -2., lower);
        const Eigen::MatrixXd expected =
          lower ? Eigen::MatrixXd(PAP.triangularView<Eigen::Lower>()) : PAP;
        check_equal(dense(t, m), -2. * expected, text + ": entries");
      }

    std::vector<Functionals::Row> rows;
    for (std::size_t k = 0; k < c.dependent.rows.size(); ++k)
      rows.push_back({{unsigned(k % n), 1.5}, {unsigned((k + 3) % n), -.5}});
    const auto tangential =
      std::make_shared<const Functionals>(c.space, std::move(rows));
    const Eigen::MatrixXd L = as_dense(*tangential, n) * c.P;
    check_equal(as_dense(*c.elimination->reduce(*tangential), m),
                L,
                text + ": functionals");
    // What takes forces out of the rows, dependent or not.
    std::vector<Functionals::Row> out;
    for (std::size_t k = 0; k < c.dependent.rows.size(); ++k)
      out.push_back({{c.dependent.rows[k], .8}, {unsigned((k + 5) % n), -.6}});
    const Functionals        normal(c.space, std::move(out));
    const MultiplierFriction friction(
      *matrix, *c.elimination, c.elimination->reduce(*tangential), normal);
    const Eigen::MatrixXd G = as_dense(normal, n) * A * c.P;
    check_equal(
      friction.multiply(X), L.transpose() * G * X, text + ": friction");
    check_equal(friction.multiply_transposed(X),
                G.transpose() * L * X,
                text + ": friction transposed");
    Triplets t;
    friction.append_to(t, .5, false);
    check_equal(
      dense(t, m), .5 * L.transpose() * G, text + ": entries of friction");
    check(!friction.is_symmetric(), text + ": friction is not symmetric");
    check_equal(friction.multiply_absolute(X),
                L.cwiseAbs().transpose() * as_dense(normal, n).cwiseAbs() *
                  A.cwiseAbs() * c.P.cwiseAbs() * X.cwiseAbs(),
                text + ": rounding size of friction");

    // A sum applies the map once for all that have it.
    const SumOperator sum(
      {{2., std::make_shared<EliminatedOperator>(matrix, c.elimination)},
       {-.5,
        std::make_shared<EliminatedOperator>(
          std::make_shared<SparseMatrix>(c.space, lower_entries(A * A)),
          c.elimination)}});
    check_equal(sum.multiply(X),
                c.P.transpose() * (2. * A - .5 * A * A) * c.P * X,
                text + ": sum of eliminated operators");
  }

  void
  check_case(const DependentUnknowns &d, const std::string &text)
  {
    const Case  c(d);
    const auto &e = *c.elimination;
    check(e.n_dependent() == d.rows.size() &&
            e.reduced_space()->n_global() == unsigned(c.P.cols()),
          text + ": numbers");
    const Block v = Block::Random(c.P.cols(), 3), f = Block::Random(n, 3);
    check_equal(e.expand(v), c.P * v, text + ": P v");
    check_equal(e.restrict_forces(f), c.P.transpose() * f, text + ": P^T f");
    const Eigen::MatrixXd size = c.P.cwiseAbs();
    check_equal(e.expand_absolute(v), size * v.cwiseAbs(), text + ": |P| |v|");
    check_equal(e.restrict_absolute(f),
                size.transpose() * f.cwiseAbs(),
                text + ": |P|^T |f|");
    check_operators(c, text);
  }

  bool
  is_refused(const DependentUnknowns &d)
  {
    try
      {
        Elimination(std::make_shared<const RowSpace>(n), d);
      }
    catch (const dealii::ExceptionBase &)
      {
        return true;
      }
    return false;
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize init(argc, argv, 1);
  check_case({{}, {}, {}}, "nothing to eliminate");
  check_case({{3}, {{{0, .5}, {6, -.25}}}, {}}, "one row");
  // Not ascending, first and last row, one held at zero, one master thrice.
  check_case(
    {{6, 0, 4}, {{{1, .5}, {2, .5}}, {}, {{1, 2.}, {5, -1.}, {3, .125}}}, {}},
    "three rows");
  check_case({{0, 1, 2, 3, 4, 5},
              {{{6, 1.}}, {{6, -1.}}, {{6, 2.}}, {{6, 1.}}, {}, {{6, .5}}},
              {}},
             "all but one row");
  check(is_refused({{2, 2}, {{{0, 1.}}, {{1, 1.}}}, {}}),
        "a row that is dependent twice is refused");
  check(is_refused({{2, 3}, {{{3, 1.}}, {{1, 1.}}}, {}}),
        "a row that follows a dependent one is refused");
}
